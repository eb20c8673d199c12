import AxeBuilder from '@axe-core/playwright'
import { expect, type Page } from '@playwright/test'

/** Fails with what axe finds wrong with the page as it is now, and where. */
export async function expectAccessible(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze()
  const found = violations.flatMap(({ help, nodes }) =>
    nodes.map(({ target }) => `${help}: ${target.join(' ')}`),
  )
  expect(found, 'what axe finds').toEqual([])
}
