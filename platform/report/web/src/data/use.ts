import { createContext } from 'preact';
import { useContext, useEffect, useState } from 'preact/hooks';
import { objects, type Cell, type Source } from './source';

export interface Shared {
  source: Source;
  /** Counts changes of the database. */
  version: number;
}
export const SharedContext = createContext<Shared>(null as unknown as Shared);

export interface Loaded<Value> {
  value: Value | undefined;
  error: string | null;
}

/** What `load` promises; loaded again when `keys` or the database change, keeping the old value until then. */
export function useLoaded<Value>(load: (source: Source) => Promise<Value>, keys: unknown[]): Loaded<Value> {
  const { source, version } = useContext(SharedContext);
  const key = JSON.stringify(keys);
  const [state, setState] = useState<Loaded<Value> & { key: string }>({ key, value: undefined, error: null });
  useEffect(() => {
    let wanted = true;
    load(source).then(
      (value) => wanted && setState({ key, value, error: null }),
      (error: Error) => wanted && setState({ key, value: undefined, error: error.message }));
    return () => { wanted = false; };
  }, [source, version, key]);
  return state.key === key ? state : { value: undefined, error: null };
}

/** The rows of a query as objects. */
export function useRows<Row>(sql: string, values: Cell[] = []): Loaded<Row[]> {
  return useLoaded(async (source) => objects<Row>(await source.query(sql, values)), [sql, values]);
}
