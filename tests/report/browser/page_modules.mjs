// Modules of the pages that need no browser, for tests of what they compute.
import { createRequire } from 'node:module';
import { join } from 'node:path';

const web = process.env.LACUNA_WEB ?? '';

/** What `src/FILE` exports. */
export async function pageModule(file) {
  const { build } = createRequire(join(web, 'package.json'))('esbuild');
  const { outputFiles } = await build({
    entryPoints: [join(web, 'src', file)],
    bundle: true,
    write: false,
    format: 'esm',
    preserveSymlinks: true,
    absWorkingDir: web,
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);
}
