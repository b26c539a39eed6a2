// Texts of the view.
export const texts = {
  title: 'Mechanism in three dimensions',
  loadCase: 'Load case',
  colours: 'Colours',
  load: 'normal load',
  pressure: 'peak pressure',
  temperature: 'temperature of the parts',
  nut: 'Nut',
  rollers: 'Rollers',
  screw: 'Screw',
  show: 'Show',
  previous: 'Previous thread',
  next: 'Next thread',
  reset: 'Reset view',
  allNumbers: 'All of its numbers',
  help:
    'Drag to turn; with the pointer in the picture and after a click, the wheel zooms. Keys: arrows turn, + and - zoom, ' +
    'Home goes back, Page Up and Page Down go through the threads. Click a thread for its numbers. The nut is cut open; ' +
    'contacts are drawn larger than they are.',
  summary: ({ type, rollers, contacts, loadCase }) =>
    `${type} roller screw, ${rollers} rollers with ${contacts} threads each${loadCase ? `, load case ${loadCase}` : ''}.`,
  largest: ({ side, place, value }) => `Largest ${side}: ${value} at ${place}.`,
  atScrew: 'at the screw',
  atNut: 'at the nut',
  place: ({ roller, thread, manyRollers }) =>
    manyRollers ? `roller ${roller}, thread ${thread}` : `thread ${thread} of each roller`,
  unloaded: 'no load',
  types: { standard: 'Standard', inverted: 'Inverted', recirculating: 'Recirculating' },
};
