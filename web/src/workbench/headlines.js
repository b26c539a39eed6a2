// What a reader looks at first: quantities of the documents, by their paths of `prs list responses`.
import { page, state } from './store.js';
import { steps } from './schema.js';

/** Of each load case, and of the whole case, as `prs compare` has them. */
const ofLoadCase = [
  ['solve', 'axial_stiffness_N_per_um'],
  ['solve', 'axial_displacement_um'],
  ['solve', 'screw.peak_pressure_MPa.max'],
  ['solve', 'nut.peak_pressure_MPa.max'],
  ['solve', 'screw.load_rate_percent.max'],
  ['solve', 'nut.load_rate_percent.max'],
  ['slip', 'slip.efficiency'],
  ['slip', 'slip.power_loss_W'],
  ['slip', 'slip.torque_screw_Nm'],
  ['slip', 'heat.temperature_degC.nut'],
  ['measures', 'measures.solved_static_safety'],
];
const ofWhole = [
  ['life', 'life.static_safety'],
  ['life', 'life.system.l10_hours'],
  ['life', 'life.system.l10_revolutions'],
  ['life', 'life.catalogue.l10_hours'],
  ['preload', 'preload.lost_motion_um'],
  ['measures', 'measures.dynamic_capacity_N'],
  ['measures', 'measures.weight_kg'],
  ['contact', 'contact.screw.backlash_mm'],
  ['contact', 'contact.nut.backlash_mm'],
];

const listed = new Map(page.responses.map((row) => [row.path, row]));

/** The number at a path of a record: of lists the `max`, `min` or `mean`. */
export function numberAt(record, path) {
  let value = record;
  for (const step of steps(path)) {
    if (Array.isArray(value) && typeof step === 'string') {
      const numbers = value.flat().filter((x) => typeof x === 'number');
      if (numbers.length === 0) return undefined;
      if (step === 'max') value = Math.max(...numbers);
      else if (step === 'min') value = Math.min(...numbers);
      else if (step === 'mean') value = numbers.reduce((a, b) => a + b, 0) / numbers.length;
      else return undefined;
    } else value = value?.[step];
  }
  return typeof value === 'number' ? value : undefined;
}

/** A response of documents: of the load case where it has it, else of the whole. */
export function responseIn(document, path, loadCase) {
  const cases = document?.load_cases ?? [];
  return numberAt(cases[Math.min(loadCase, cases.length - 1)], path) ?? numberAt(document, path);
}

export const responseInfo = (path) => listed.get(path) ?? { path, unit: '', title: path };

const words = { static: ', at rest', running: ', running' };

/** Whether a number of thread loads is that of the screw at rest or running: `, at rest`. */
function stateOf(command, path, document, loadCase) {
  if (/static_safety$/.test(path)) return words.static;
  if (command === 'life') return words[document.life?.thread_loads] ?? '';
  return command === 'solve' ? words[document.load_cases?.[loadCase]?.loads] ?? '' : '';
}

/** The same of the loads that pictures over the threads show. */
export const stateOfLoads = ({ documents }) => (documents.solve ? stateOf('solve', '', documents.solve, state.loadCase) : '');

/** [{path, value, unit, title, whole}] of a variant, for the load case that is chosen. */
export function headlinesOf(variant, loadCase = state.loadCase) {
  const found = [];
  const add = (rows, whole) => {
    for (const [command, path] of rows) {
      const document = variant.documents[command] ?? (command === 'solve' ? variant.documents.contact : undefined);
      const value = responseIn(document, path, loadCase);
      if (value === undefined) continue;
      const info = responseInfo(path);
      found.push({ ...info, title: `${info.title}${stateOf(command, path, document, loadCase)}`, path, value, whole });
    }
  };
  add(ofLoadCase, false);
  add(ofWhole, true);
  return found;
}

export const loadCaseNames = (variant) =>
  (variant.documents.solve ?? variant.documents.contact)?.load_cases?.map((c) => c.name) ?? [];
