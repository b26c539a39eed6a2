/** Bytes of a text in base 85, see `base85` in prs/page/page.cpp. */
export function bytesOf(text) {
  const [length, letters] = text.trim().split(' ');
  const view = new DataView(new ArrayBuffer((letters.length / 5) * 4));
  for (let k = 0; k < letters.length; k += 5) {
    let four = 0;
    for (let j = k; j < k + 5; j++) {
      const code = letters.charCodeAt(j);
      four = four * 85 + (code === 125 ? 20 : code === 126 ? 52 : code - 40);
    }
    view.setUint32((k / 5) * 4, four);
  }
  return new Uint8Array(view.buffer, 0, Number(length));
}

/** Runs a script that stands in the page gzipped, in base 85, and that its policy names by its hash. */
export async function run(id) {
  const script = document.createElement('script');
  script.type = 'module';
  script.textContent = await unpacked(document.getElementById(id).textContent).text();
  document.body.append(script);
}

/** What a text in base 85 has packed, as a response. */
export function unpacked(text, form = 'gzip') {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream(form));
  return new Response(stream);
}
