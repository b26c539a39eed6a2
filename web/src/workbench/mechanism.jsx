// The mechanism in three dimensions, whose script is loaded when it is looked at.
import { useEffect, useRef, useState } from 'preact/hooks';
import { loadMechanism } from '../page/mechanism.js';
import { current, state } from './store.js';
import { t } from './texts.js';

const documentOf = ({ documents }) => documents.slip ?? documents.solve ?? documents.contact;

export function Mechanism() {
  const place = useRef(null);
  const view = useRef(null);
  const shown = useRef(null);
  const [seen, setSeen] = useState(false);
  const document = documentOf(current());

  // With the verdict all above it is there: what is in sight then is looked at.
  const isReady = Boolean(current().documents.check);
  useEffect(() => {
    if (!globalThis.WebGL2RenderingContext || !isReady) return undefined;
    const observer = new IntersectionObserver((entries) => setSeen(entries.at(-1).isIntersecting));
    observer.observe(place.current);
    return () => observer.disconnect();
  }, [isReady]);
  useEffect(() => () => view.current?.dispose(), []);

  useEffect(() => {
    if (!document?.contact) {
      view.current?.dispose();
      view.current = shown.current = null;
    }
    if (!seen || !document?.contact) return;
    const key = [document, state.loadCase];
    if (shown.current && key.every((part, k) => part === shown.current[k])) return;
    shown.current = key;
    loadMechanism().then((mount) => {
      if (!place.current) return;
      if (view.current) return void view.current.update(document, state.loadCase);
      view.current = mount(place.current, { document, loadCase: state.loadCase });
    });
  });

  return (
    <section aria-labelledby="mechanism-title" hidden={!globalThis.WebGL2RenderingContext}>
      <h2 id="mechanism-title">{t('mechanism3d')}</h2>
      <div class="mechanism-place" ref={place} />
    </section>
  );
}
