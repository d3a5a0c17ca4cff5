import { createContext } from 'preact';
import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { AnswersOf, sameAnswers, type Answers } from './answers_of';
import { objects, type Source, type Value as Bound } from './source';

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

/** What `load` promises; loaded again when `keys` or the database change. The old value is kept until then, and after it
 *  where the database answers the same again, so that what a viewer does goes on. */
export function useLoaded<Value>(load: (source: Source) => Promise<Value>, keys: unknown[]): Loaded<Value> {
  const { source, version } = useContext(SharedContext);
  const key = JSON.stringify(keys);
  const [state, setState] = useState<Loaded<Value> & { key: string }>({ key, value: undefined, error: null });
  const known = useRef<{ key: string; answers: Answers } | null>(null);
  useEffect(() => {
    let wanted = true;
    const asked = new AnswersOf(source);
    const take = (value: Value) => {
      const same = known.current?.key === key && sameAnswers(known.current.answers, asked.answers);
      known.current = { key, answers: asked.answers };
      setState((old) => {
        if (!same || old.key !== key || old.value === undefined) return { key, value, error: null };
        return old.error === null ? old : { ...old, error: null };
      });
    };
    load(source.live ? asked : source).then(
      (value) => wanted && take(value),
      (error: Error) =>
        wanted && setState((old) => ({ key, value: old.key === key ? old.value : undefined, error: error.message })),
    );
    return () => {
      wanted = false;
    };
  }, [source, version, key]);
  return state.key === key ? state : { value: undefined, error: null };
}

/** The rows of a query as objects. */
export function useRows<Row>(sql: string, values: Bound[] = []): Loaded<Row[]> {
  return useLoaded(async (source) => objects<Row>(await source.query(sql, values)), [sql, values]);
}
