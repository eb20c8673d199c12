export const capitalised = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1)

export const asSentence = (text: string): string => `${capitalised(text)}.`

/** "no-path" → "No path": a choice of a parameter as it is shown. */
export const choiceInWords = (choice: string): string => capitalised(choice.replaceAll('-', ' '))
