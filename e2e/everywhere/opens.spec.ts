import { expectAccessible } from '../accessibility'
import { expect, test } from '../fixtures'

test('the page opens with a map that is solved', async ({ map, page }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  await expect(page.getByText(/^Reached in \d+ cells$/).first()).toBeVisible()
  await expectAccessible(page)
})
