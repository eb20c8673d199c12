/** Some browsers ask for a module once only: what failed stays missing until the page is loaded anew. */
export const MISSING_PART =
  'This part of the page could not be loaded. Try again once its server can be reached; if that does not help, reload the page.'

/**
 * A part of the page that is fetched when it is first needed.
 * @throws Error in words for those who need it, where the browser's tell of addresses
 */
export async function fetchedPart<Part>(part: Promise<Part>): Promise<Part> {
  try {
    return await part
  } catch {
    throw new Error(MISSING_PART)
  }
}
