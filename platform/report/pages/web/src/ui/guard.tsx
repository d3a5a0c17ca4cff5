import { Component, type ComponentChildren } from 'preact';

/** Shows an error of its content in its place, so that the rest of the page keeps working. */
export class Guard extends Component<{ children: ComponentChildren }, { error: string | null }> {
  override state = { error: null as string | null };

  override componentDidCatch(error: unknown): void {
    this.setState({ error: error instanceof Error ? error.message : String(error) });
  }

  override render() {
    if (this.state.error === null) return this.props.children;
    return (
      <p class="error" role="alert">
        This page cannot show what the database has: {this.state.error}
      </p>
    );
  }
}
