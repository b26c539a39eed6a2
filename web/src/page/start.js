// Starts the page's script, which the page's policy lets run by the hash of its text.
import { run } from './packed.js';

run('script');
