import { t } from './texts.js';
export const Studies = () => <section><h2>{t('studies')}</h2></section>;
