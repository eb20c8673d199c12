/** Shows how much is done, from 0 to 1. Of work that has not said it yet the bar only moves. */
export function showProgress(bar: Element | null, done: number): void {
  const filling = bar?.firstElementChild
  if (!bar || !(filling instanceof HTMLElement)) return
  const percent = Math.round(done * 100)
  filling.className = percent > 0 ? 'determinate' : 'indeterminate'
  filling.style.width = percent > 0 ? `${percent}%` : ''
  if (percent > 0) bar.setAttribute('aria-valuenow', String(percent))
  else bar.removeAttribute('aria-valuenow')
}
