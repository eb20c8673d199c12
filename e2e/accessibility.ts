import AxeBuilder from '@axe-core/playwright'
import { expect, type Page } from '@playwright/test'

const REFERENCES = ['aria-describedby', 'aria-labelledby', 'aria-controls', 'for']

/** Fails with what axe finds wrong with the page as it is now, and where; and with names of nothing. */
export async function expectAccessible(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze()
  const found = violations.flatMap(({ help, nodes }) =>
    nodes.map(({ target }) => `${help}: ${target.join(' ')}`),
  )
  expect(found, 'what axe finds').toEqual([])
  const missing = await page.evaluate(
    (attributes) =>
      attributes.flatMap((attribute) =>
        [...document.querySelectorAll(`[${attribute}]`)]
          .flatMap((element) => (element.getAttribute(attribute) ?? '').split(' '))
          .filter((id) => !document.getElementById(id))
          .map((id) => `${attribute}="${id}"`),
      ),
    REFERENCES,
  )
  expect(missing, 'elements that others name and that are not there').toEqual([])
}
