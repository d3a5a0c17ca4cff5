import { ServerSource } from './server_source';
import type { Source } from './source';
import { StaticSource } from './static_source';

/** The copy inside this page where there is one, else the server that it came from. */
export async function openSource(): Promise<Source> {
  const element = document.getElementById('lacuna-data');
  if (!element) return new ServerSource();
  const text = element.textContent ?? '';
  element.remove();
  return StaticSource.open(text);
}
