import { Fragment, type ComponentChildren } from 'preact';
import type { Loaded } from '../data/use';

export function Empty({ children }: { children: ComponentChildren }) {
  return <p class="empty">{children}</p>;
}

/** What was loaded, or why it could not be; what was there before stays. */
export function Show<Value>({ of, children }: { of: Loaded<Value>; children: (value: Value) => ComponentChildren }) {
  return (
    <>
      {of.error !== null && (
        <p class="error" role="alert">
          {of.error}
        </p>
      )}
      {of.value !== undefined ? (
        <Fragment key="value">{children(of.value)}</Fragment>
      ) : (
        of.error === null && <p class="empty loading">loading …</p>
      )}
    </>
  );
}

interface SelectProps {
  label: string;
  value: string;
  options: { value: string; label: string }[];
  change: (value: string) => void;
}

export function Select({ label, value, options, change }: SelectProps) {
  return (
    <label class="select">
      <span>{label}</span>
      <select value={value} onChange={(event) => change(event.currentTarget.value)}>
        {options.map((one) => (
          <option key={one.value} value={one.value}>
            {one.label}
          </option>
        ))}
      </select>
      <strong class="on-paper">{options.find((one) => one.value === value)?.label ?? value}</strong>
    </label>
  );
}

/** Letters of a key that does something. */
export const Key = ({ children }: { children: ComponentChildren }) => <kbd>{children}</kbd>;

/** An address or a name of several words, which may go on in the next line behind "." and "_". */
export const Breakable = ({ children }: { children: string }) => (
  <span class="breakable">
    {children.split(/(?<=[._])/).map((part, i) => (
      <Fragment key={i}>
        {i > 0 && <wbr />}
        {part}
      </Fragment>
    ))}
  </span>
);
