import { useEffect, useState } from 'preact/hooks';

/** Where the reader is: "#/compare?revision=2" is page "compare" with its choices. Every view has such a link. */
export interface Route {
  page: string;
  choices: Record<string, string>;
}

export function parseRoute(hash: string): Route {
  const [path, query = ''] = hash.replace(/^#\/?/, '').split('?');
  return { page: decodeURIComponent(path), choices: Object.fromEntries(new URLSearchParams(query)) };
}

export function linkTo(page: string, choices: Record<string, string | number | null | undefined> = {}): string {
  const query = new URLSearchParams();
  for (const [key, value] of Object.entries(choices))
    if (value !== null && value !== undefined && value !== '') query.set(key, String(value));
  const text = query.toString();
  return `#/${page}${text ? `?${text}` : ''}`;
}

export function useRoute(): Route {
  const [route, setRoute] = useState(() => parseRoute(location.hash));
  useEffect(() => {
    const changed = () => setRoute(parseRoute(location.hash));
    addEventListener('hashchange', changed);
    return () => removeEventListener('hashchange', changed);
  }, []);
  return route;
}

/** Changes choices of the page that is open; null takes one away. */
export function choose(changes: Record<string, string | number | null>, page?: string): void {
  const route = parseRoute(location.hash);
  location.hash = linkTo(page ?? route.page, { ...route.choices, ...changes });
}
