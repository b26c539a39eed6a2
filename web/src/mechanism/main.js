// A script of its own, which page/mechanism.js loads when a mechanism is looked at.
import { mount } from './mount.js';

document.dispatchEvent(new CustomEvent('prs-mechanism', { detail: mount }));
