import { render } from 'preact';
import { openSource } from './data/open';
import { App } from './app';

const page = document.getElementById('page')!;
const say = (text: string) => {
  const line = document.createElement('p');
  line.className = 'error';
  line.textContent = text;
  page.replaceChildren(line);
};

openSource().then(
  (source) => render(<App source={source} />, page),
  (error: Error) =>
    say(`The data of this report cannot be opened: ${error.message}. It needs a browser of 2023 or later.`),
);
