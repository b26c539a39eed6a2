// Studies of the case at hand.
import { useEffect, useRef } from 'preact/hooks';
import { mount } from '../studies/mount.js';
import * as studyTexts from '../studies/texts.js';
import { titleOf } from './form.jsx';
import { current, page, state } from './store.js';
import { engine, question } from './study.js';
import { t } from './texts.js';

export function Studies() {
  const place = useRef(null);
  const view = useRef(null);
  const { documents } = current();
  const known = Object.keys(documents).length;

  useEffect(() => {
    const texts = state.language === 'de' ? studyTexts.german : studyTexts.texts;
    view.current = mount(place.current, {
      question, engine, texts, responses: page.responses, title: titleOf, documents: () => current().documents,
    });
    return () => view.current.dispose();
  }, [state.language]);
  useEffect(() => {
    view.current.refresh();
  }, [documents.check, known]);

  return (
    <section aria-labelledby="studies-title">
      <h2 id="studies-title">{t('studies')}</h2>
      <div ref={place} />
    </section>
  );
}
