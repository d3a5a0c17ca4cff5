import type { ComponentChildren } from 'preact';
import type { Loaded } from '../data/use';

export function Empty({ children }: { children: ComponentChildren }) {
  return <p class="empty">{children}</p>;
}

/** What was loaded, or why it could not be. */
export function Show<Value>({ of, children }: { of: Loaded<Value>; children: (value: Value) => ComponentChildren }) {
  if (of.error !== null) return <p class="error" role="alert">{of.error}</p>;
  if (of.value === undefined) return <p class="empty loading">loading …</p>;
  return <>{children(of.value)}</>;
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
        {options.map((one) => <option key={one.value} value={one.value}>{one.label}</option>)}
      </select>
    </label>
  );
}

/** Letters of a key that does something. */
export const Key = ({ children }: { children: ComponentChildren }) => <kbd>{children}</kbd>;
