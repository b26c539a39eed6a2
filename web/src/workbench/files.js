// Files in and out: the browser's own dialogs, nothing else.

/** Saves a text as a file by a link of the page. */
export function saveFile(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

/** Cases and the tables that they name: {cases: [{name, text}], tables: {name: text}}. */
export async function readFiles(list) {
  const cases = [];
  const tables = {};
  for (const file of list) {
    const text = await file.text();
    if (/\.(csv|txt|dat)$/i.test(file.name)) tables[file.name] = text;
    else cases.push({ name: file.name, text });
  }
  return { cases, tables };
}
