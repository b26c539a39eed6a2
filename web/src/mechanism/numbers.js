// What the view shows of a document: numbers of its threads and temperatures of its parts, as they stand there.

export const sides = ['screw', 'nut'];

export const quantities = {
  load: { key: 'normal_load_N', unit: 'N' },
  pressure: { key: 'peak_pressure_MPa', unit: 'MPa' },
};

/** Of a thread of a roller, both from 0; null where the document has none. */
export function threadNumber(loadCase, side, key, roller, thread) {
  const numbers = loadCase?.[side]?.[key];
  if (!numbers) return null;
  return (Array.isArray(numbers[0]) ? numbers[roller]?.[thread] : numbers[thread]) ?? null;
}

/** Whether each roller has numbers of its own. */
export const hasRollers = (loadCase) => Array.isArray(loadCase?.screw?.normal_load_N?.[0]);

/** Whether the loads are those of the screw at rest or running; nothing where no model has solved them. */
export const stateOf = (loadCase) => ({ static: 'at rest', running: 'running' })[loadCase?.loads] ?? '';

/** Temperatures of screw, rollers and nut: of the cycle that repeats itself, else of the load case. */
export function temperatures(document, loadCase) {
  return loadCase?.heat?.temperature_degC ?? document.heat_cycle?.peak_degC ?? null;
}

/** The largest number of all threads: where and how much. */
export function largest(loadCase, key, rollers, contacts) {
  let found = null;
  for (const side of sides)
    for (let roller = 0; roller < (hasRollers(loadCase) ? rollers : 1); roller++)
      for (let thread = 0; thread < contacts; thread++) {
        const value = threadNumber(loadCase, side, key, roller, thread);
        if (value !== null && !(value <= found?.value)) found = { side, roller, thread, value };
      }
  return found;
}

/** Four digits, as pages write loads. */
export const shown = (value) => (value === 0 ? '0' : String(Number(value.toPrecision(4))));
