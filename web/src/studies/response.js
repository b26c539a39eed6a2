// Numbers of documents by their paths, as studies name them (prs/study/response.h).

const isSeries = (value) =>
  Array.isArray(value) && value.length > 0 && value.every((each) => typeof each === 'number' || isSeries(each));

const summaries = {
  max: (values) => Math.max(...values),
  min: (values) => Math.min(...values),
  mean: (values) => values.reduce((sum, value) => sum + value, 0) / values.length,
};

function numberAt(value, path) {
  if (path === '') return typeof value === 'number' ? value : null;
  const index = path.match(/^\[(\d+)\]/);
  if (index) return Array.isArray(value) ? numberAt(value[Number(index[1])], path.slice(index[0].length)) : null;
  const summary = summaries[path.slice(1)];
  if (summary && isSeries(value)) return summary(value.flat(Infinity));
  if (!path.startsWith('.') || value === null || typeof value !== 'object') return null;
  const [key] = path.slice(1).split(/[.[]/, 1);
  return Object.hasOwn(value, key) ? numberAt(value[key], path.slice(1 + key.length)) : null;
}

/** The number at a path of the first load case or, where that has none, of the document; null: none. */
export function response(document, path) {
  const first = document?.load_cases?.[0];
  return (first && numberAt(first, `.${path}`)) ?? numberAt(document, `.${path}`);
}

function listPaths(value, path, paths) {
  if (typeof value === 'number') paths.push(path);
  else if (isSeries(value)) paths.push(`${path}.max`);
  else if (value !== null && typeof value === 'object' && !Array.isArray(value))
    for (const [key, each] of Object.entries(value)) listPaths(each, path ? `${path}.${key}` : key, paths);
}

/** Every path of a document that has a number, of several the largest. */
export function responsePaths(document) {
  const paths = [];
  if (document.load_cases?.[0]) listPaths(document.load_cases[0], '', paths);
  listPaths(document, '', paths);
  return [...new Set(paths)];
}

/** What stands at the path of an input, as `resolved_input` has it; undefined where nothing does. */
export function inputAt(input, path) {
  let value = input;
  for (const [, key, place] of path.matchAll(/([^.[\]]+)|\[([^\]]+)\]/g)) {
    if (value === null || typeof value !== 'object') return undefined;
    if (place === undefined) value = value[key];
    else value = /^\d+$/.test(place) ? value[Number(place)] : value.find?.((each) => each.name === place);
  }
  return value;
}
