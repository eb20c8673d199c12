import { expectAccessible } from '../accessibility'
import { chooseFromMapMenu, choosePlanner, dropFile, unfold } from '../actions'
import { expect, test } from '../fixtures'
import { openScenario, press, reasons } from '../steps'

test('axe finds nothing in the cards, the menu and the messages', async ({ page }) => {
  for (const card of ['planner', 'result']) {
    await unfold(page, card)
    await expectAccessible(page)
  }
  await dropFile(page, 'broken.json', '{')
  await expect(page.getByRole('alert')).toBeVisible()
  await page.getByRole('button', { name: 'Map', exact: true }).click()
  await expect(page.getByRole('menu')).toBeVisible()
  await expectAccessible(page)
})

test('axe finds nothing in the dialogs', async ({ page }) => {
  const close = async (name: string) => {
    const dialog = page.getByRole('dialog', { name })
    await expect(dialog).toBeVisible()
    await expectAccessible(page)
    await page.keyboard.press('Escape')
    await expect(dialog).toBeHidden()
  }
  await page.getByRole('button', { name: 'Help and keys' }).click()
  await close('Help and keys')
  await chooseFromMapMenu(page, 'New…')
  await page.getByRole('spinbutton', { name: 'Width' }).fill('1')
  await page.keyboard.press('Enter')
  await close('New map')
  await chooseFromMapMenu(page, 'Generate…')
  await close('Generate a map')
  await chooseFromMapMenu(page, 'Scenarios…')
  await close('Scenarios')
  await choosePlanner(page, 'Probabilistic roadmap')
  await unfold(page, 'planner')
  await page.getByRole('button', { name: 'What it is and promises' }).click()
  await close('Probabilistic roadmap')
})

test('axe finds nothing in the steps, whichever card is open', async ({ page }) => {
  await openScenario(page, 'Fig. 12: The spiral, Bug2')
  await press(page, 'ArrowLeft')
  await page.getByRole('application').focus()
  await press(page, 'ArrowDown', 2)
  for (const card of ['planner card', 'result card', 'card of steps']) {
    const fold = page.getByRole('button', { name: `Fold the ${card}` })
    const isOpen = (await fold.getAttribute('aria-expanded')) === 'true'
    if (!isOpen) await fold.click()
    if (!isOpen || card === 'card of steps') await expectAccessible(page)
  }
  await expect(reasons(page).getByRole('button', { name: /: step \d+/ })).toBeVisible()
  await expect(page.getByRole('list', { name: 'Pseudocode' })).toBeVisible()
})
