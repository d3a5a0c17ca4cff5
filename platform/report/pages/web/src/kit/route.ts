import { useEffect, useState } from 'preact/hooks';

/** Where the reader is: "#/compare?revision=2" is page "compare" with its choices. Every view has such a link. */
export interface Route {
  page: string;
  choices: Record<string, string>;
}

/** As it was written where it cannot be decoded. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

export function parseRoute(hash: string): Route {
  const [path, query = ''] = hash.replace(/^#\/?/, '').split('?');
  return { page: decoded(path), choices: Object.fromEntries(new URLSearchParams(query)) };
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

type Changes = Record<string, string | number | null>;

function linkWith(changes: Changes): string {
  const route = parseRoute(location.hash);
  return linkTo(route.page, { ...route.choices, ...changes });
}

/** Changes choices of the page that is open; null takes one away. */
export function choose(changes: Changes): void {
  location.hash = linkWith(changes);
}

/** The same where going back should not undo it step by step, as with the letters of a filter. */
export function refine(changes: Changes): void {
  location.replace(linkWith(changes));
}

/** A sentence where an address asks for something that is not here: "There is no run 77 here." */
export function notHere(what: string, asked: string | undefined, here: (string | number)[]): string | null {
  return asked === undefined || here.some((one) => String(one) === asked) ? null : `There is no ${what} ${asked} here.`;
}
