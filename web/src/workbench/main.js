// The workbench.
globalThis.prs = {};
