import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { fitPaper, leavePaper, whenPrinted } from '../kit/paper';

interface Props {
  title: ComponentChildren;
  note?: ComponentChildren;
  /** How it can be kept; absent: it cannot. */
  downloads?: { label: string; run: () => void }[];
  children: ComponentChildren;
}

/** A picture or a table with a title above it and downloads beside that. */
export function Figure({ title, note, downloads = [], children }: Props) {
  const figure = useRef<HTMLElement>(null);
  useEffect(
    () =>
      whenPrinted(
        () => fitPaper(figure.current!),
        () => leavePaper(figure.current!),
      ),
    [],
  );
  return (
    <figure class="figure" ref={figure}>
      <figcaption>
        <span class="figure-title">{title}</span>
        {downloads.map((one) => (
          <button key={one.label} class="quiet download" title={`Download as ${one.label}`} onClick={one.run}>
            {one.label}
          </button>
        ))}
      </figcaption>
      {children}
      {note && <p class="note">{note}</p>}
    </figure>
  );
}
