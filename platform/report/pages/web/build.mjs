// node build.mjs OUTPUT: the pages as one HTML file without data. The program puts these in place of two marks:
//   %CONNECT%          what the page may connect to: 'none' in a file, 'self' when it is served
//   <!--lacuna-data--> where a report's database goes
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';

const common = {
  bundle: true,
  minify: true,
  write: false,
  target: 'es2022',
  format: 'iife',
  preserveSymlinks: true,
  legalComments: 'none',
  logLevel: 'warning',
  loader: { '.wasm': 'binary', '.css': 'text' },
  alias: { fs: './src/data/nothing.ts', path: './src/data/nothing.ts', crypto: './src/data/nothing.ts' },
};

const bundle = async (entry, more = {}) => {
  const result = await build({ ...common, entryPoints: [entry], ...more });
  return result.outputFiles[0].text;
};

const worker = await bundle('src/data/worker.ts');
const workerText = {
  name: 'worker-text',
  setup(plugin) {
    plugin.onResolve({ filter: /^worker-text$/ }, () => ({ path: 'worker-text', namespace: 'worker' }));
    plugin.onLoad({ filter: /.*/, namespace: 'worker' }, () => ({ contents: worker, loader: 'text' }));
  },
};
const script = await bundle('src/main.tsx', { jsx: 'automatic', jsxImportSource: 'preact', plugins: [workerText] });
const style = (
  await Promise.all(
    [
      'node_modules/uplot/dist/uPlot.min.css',
      'node_modules/tabulator-tables/dist/css/tabulator_simple.min.css',
      'src/style.css',
    ].map(async (file) => {
      const result = await build({ entryPoints: [file], minify: true, write: false, target: 'es2022' });
      return result.outputFiles[0].text.replace(/\/\*# sourceMappingURL.*\*\//g, '');
    }),
  )
).join('');

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} 'wasm-unsafe-eval' blob:`,
  `style-src ${hash(style)}`,
  'img-src data: blob:',
  'worker-src blob:',
  'connect-src %CONNECT%',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');
const icon =
  'data:image/svg+xml,%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 viewBox=%220 0 16 16%22%3E' +
  '%3Cpath d=%22M2 8a6 6 0 1 1 6 6%22 fill=%22none%22 stroke=%22%230072b2%22 stroke-width=%223%22/%3E%3C/svg%3E';
writeFileSync(
  process.argv[2],
  `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<title>Lacuna</title>
<link rel="icon" href="${icon}">
<style>${style}</style>
</head>
<body>
<div id="page"></div>
<noscript>This report needs JavaScript; it contains all scripts.</noscript>
<!--lacuna-data-->
<script>${script}</script>
</body>
</html>
`,
);
