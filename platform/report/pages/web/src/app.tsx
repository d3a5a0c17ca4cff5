import { useEffect, useMemo, useState } from 'preact/hooks';
import type { Source } from './data/source';
import { SharedContext, useRows } from './data/use';
import { isTaken } from './kit/keys';
import { linkTo, useRoute } from './kit/route';
import { pages } from './pages';
import { Finder } from './ui/finder';
import { Guard } from './ui/guard';
import { Empty } from './ui/parts';
import { useTheme } from './ui/theme';

/** 1 to 8 open pages, / goes to the page's search field or, where it has none, to that of all pages. */
function useKeys(): void {
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (isTaken(event)) return;
      const page = pages[Number(event.key) - 1];
      if (page) location.hash = linkTo(page.name);
      else if (event.key === '/')
        (
          document.querySelector<HTMLElement>('main .search') ?? document.querySelector<HTMLElement>('.search')
        )?.focus();
      else return;
      event.preventDefault();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, []);
}

export function App({ source }: { source: Source }) {
  const [version, setVersion] = useState(0);
  const [trouble, setTrouble] = useState<string | null>(null);
  useEffect(() => source.watch(() => setVersion((one) => one + 1), setTrouble), [source]);
  const shared = useMemo(() => ({ source, version }), [source, version]);
  return (
    <SharedContext.Provider value={shared}>
      <Frame source={source} trouble={trouble} />
    </SharedContext.Provider>
  );
}

function Frame({ source, trouble }: { source: Source; trouble: string | null }) {
  const route = useRoute();
  const [theme, changeTheme] = useTheme();
  useKeys();
  const start = pages[0].name;
  const unknown = route.page !== '' && !pages.some((one) => one.name === route.page);
  const page = pages.find((one) => one.name === (route.page || start)) ?? null;
  useEffect(() => {
    if (page) document.title = `${page.title} · Lacuna`;
  }, [page]);
  return (
    <>
      <header class="top">
        <a class="brand" href={linkTo(start)}>
          Lacuna
        </a>
        <nav aria-label="Pages">
          {pages.map((one, i) => (
            <a
              key={one.name}
              href={linkTo(one.name)}
              aria-current={one === page ? 'page' : undefined}
              title={`${one.sentence} (${i + 1})`}
            >
              {one.title}
            </a>
          ))}
        </nav>
        {source.live && (
          <span class={`live ${trouble ? 'broken' : ''}`} title={trouble ?? 'The page updates when the database changes'}>
            {trouble ? 'not connected' : 'live'}
          </span>
        )}
        <Finder />
        <button class="quiet" onClick={changeTheme} title="Colours: light, dark, or like the system">
          {theme}
        </button>
      </header>
      {trouble && (
        <p class="error" role="status">
          {trouble}
        </p>
      )}
      <Notes />
      <main>
        {unknown && <Empty>There is no page “{route.page}”. The pages are listed at the top.</Empty>}
        {page && (
          <Guard key={page.name}>
            <page.Page choices={route.choices} />
          </Guard>
        )}
      </main>
      <Foot />
    </>
  );
}

/** What a report leaves out. */
function Notes() {
  const notes = useRows<{ sentence: string }>('SELECT sentence FROM page_note ORDER BY position');
  if (!notes.value?.length) return null;
  return (
    <ul class="notes" role="note">
      {notes.value.map((one) => (
        <li key={one.sentence}>{one.sentence}</li>
      ))}
    </ul>
  );
}

function Foot() {
  const about = useRows<{ name: string; value: string }>('SELECT name, value FROM page_about ORDER BY position');
  return (
    <footer>
      {(about.value ?? []).map((one) => (
        <span key={one.name}>
          {one.name} {one.value}
        </span>
      ))}
    </footer>
  );
}
