import { newDialog } from './dialog'
import markup from './help.html?raw'

/** Makes the dialog of help and keys; returns what opens it. */
export function helpDialog(): () => void {
  const element = newDialog('help-dialog', markup)
  return () => element.showModal()
}
