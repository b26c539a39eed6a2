// Starts the page's script, which stands in it gzipped, in base 85: as a script element, which the
// page's policy lets run by the hash of its text.
import { unpacked } from './packed.js';

unpacked(document.getElementById('script').textContent)
  .text()
  .then((text) => {
    const script = document.createElement('script');
    script.type = 'module';
    script.textContent = text;
    document.body.append(script);
  });
