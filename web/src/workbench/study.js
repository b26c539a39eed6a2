// A study of one input, design by design.
import { current, questionOf } from './store.js';
