/** The elements of an SVG file by their names; throws if its tags are not nested soundly. */
export function elementsOf(svg: string): { name: string; attributes: Map<string, string> }[] {
  const elements: { name: string; attributes: Map<string, string> }[] = []
  const open: string[] = []
  const tag = /<(\/?)([a-z]+)((?: [a-zA-Z-]+="[^"<>&]*(?:&[a-z]+;[^"<>&]*)*")*)(\/?)>/g
  const rest = svg.replace(tag, (_, end, name, attributes, empty) => {
    if (end) {
      if (open.pop() !== name) throw new Error(`</${name}> closes nothing.`)
      return ''
    }
    const pairs = [...attributes.matchAll(/ ([a-zA-Z-]+)="([^"]*)"/g)].map(
      ([, key, value]): [string, string] => [key, value],
    )
    const keys = new Map(pairs)
    if (keys.size !== pairs.length) throw new Error(`<${name}> says something twice.`)
    elements.push({ name, attributes: keys })
    if (!empty) open.push(name)
    return ''
  })
  if (open.length > 0) throw new Error(`<${open.join('>, <')}> never ends.`)
  if (/[<>]/.test(rest)) throw new Error(`Not a tag: ${rest.slice(0, 80)}`)
  return elements
}

/** The area of the rectangles `M x y h w v h h -w z` in a path. */
export function areaOf(path: string): number {
  const rects = [...path.matchAll(/M\S+ [^h]+h([^v]+)v([^h]+)h[^z]+z/g)]
  return rects.reduce((area, [, width, height]) => area + Number(width) * Number(height), 0)
}
