// Time per answer of the engine of scripts/web.sh, as a page has it: node bench/engine.mjs [SECONDS]
import {commandsFor, loadEngine, questionOn} from '../tests/engine/engine.mjs';

const seconds = Number(process.argv[2] ?? 1);
const start = performance.now();
const ask = await loadEngine();
console.log(`${(performance.now() - start).toFixed(0)} ms to load`);
for (const lesson of ['05_standard_screw.yaml', '14_flight_spectrum.yaml', '25_side_load.yaml'])
  for (const command of commandsFor(lesson)) {
    const question = JSON.stringify(questionOn(command, lesson));
    const times = [];
    for (const end = performance.now() + 1000 * seconds; performance.now() < end;) {
      const begin = performance.now();
      ask(question);
      times.push(performance.now() - begin);
    }
    times.sort((a, b) => a - b);
    console.log(`${times[times.length >> 1].toFixed(2)} ms ${command} ${lesson}`);
  }
