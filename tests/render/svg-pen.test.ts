import { describe, expect, it } from 'vitest'
import { SvgPen, svgPaint, svgText } from '../../src/render/svg-pen'

/** What a pen has drawn after `draw`. */
function drawn(draw: (pen: SvgPen) => void): string {
  const pen = new SvgPen()
  draw(pen)
  return pen.elements()
}

describe('an SVG pen', () => {
  it('fills and strokes the current path', () => {
    const svg = drawn((pen) => {
      pen.moveTo(1, 2)
      pen.beginPath()
      pen.moveTo(3, 4)
      pen.lineTo(5.126, 6)
      pen.closePath()
      pen.fillStyle = '#123456'
      pen.fill()
      pen.strokeStyle = '#abcdef'
      pen.lineWidth = 2
      pen.lineJoin = 'round'
      pen.setLineDash([1, 2])
      pen.stroke()
    })
    expect(svg.split('\n')).toEqual([
      '<path d="M3 4L5.13 6z" fill="#123456"/>',
      '<path d="M3 4L5.13 6z" fill="none" stroke="#abcdef" stroke-width="2" stroke-linejoin="round" stroke-linecap="butt" stroke-dasharray="1 2"/>',
    ])
  })

  it('draws a circle as two halves', () => {
    const svg = drawn((pen) => {
      pen.beginPath()
      pen.arc(10, 20, 5, 0, 2 * Math.PI)
      pen.fill()
    })
    expect(svg).toBe('<path d="M15 20A5 5 0 0 1 5 20A5 5 0 0 1 15 20" fill="#000000"/>')
  })

  it('joins rectangles of one colour, and keeps the order of what is drawn', () => {
    const svg = drawn((pen) => {
      pen.fillStyle = '#111111'
      pen.fillRect(0, 0, 2, 1)
      pen.fillRect(4, 0, 2, 1)
      pen.fillStyle = '#222222'
      pen.fillRect(0, 5, 1, 1)
      pen.fillText('7', 3, 3)
      pen.fillRect(1, 5, 1, 1)
    })
    expect(svg.split('\n')).toEqual([
      '<path d="M0 0h2v1h-2zM4 0h2v1h-2z" fill="#111111"/>',
      '<path d="M0 5h1v1h-1z" fill="#222222"/>',
      expect.stringContaining('<text x="3" y="3"'),
      '<path d="M1 5h1v1h-1z" fill="#222222"/>',
    ])
  })

  it('writes text where a canvas does', () => {
    const svg = drawn((pen) => {
      pen.font = 'bold 9px Roboto'
      pen.textAlign = 'center'
      pen.textBaseline = 'middle'
      pen.fillText('<a & "b">', 1, 2)
    })
    expect(svg).toBe(
      '<text x="1" y="2" text-anchor="middle" dominant-baseline="central" style="font:bold 9px Roboto" fill="#000000">&lt;a &amp; &quot;b&quot;></text>',
    )
  })

  it('leaves out what cannot be seen', () => {
    expect(drawn((pen) => pen.stroke())).toBe('')
  })
})

describe('colours and text in SVG', () => {
  it('keep opacity apart, as programs other than browsers need it', () => {
    expect(svgPaint('fill', 'rgba(143, 211, 255, 0.12)')).toBe(
      ' fill="rgb(143,211,255)" fill-opacity="0.12"',
    )
    expect(svgPaint('stroke', '#102030', 0.5)).toBe(' stroke="#102030" stroke-opacity="0.5"')
    expect(svgPaint('stroke', '#102030')).toBe(' stroke="#102030"')
  })

  it('cannot break out of their place', () => {
    expect(svgText('</title><x y="1">&')).toBe('&lt;/title>&lt;x y=&quot;1&quot;>&amp;')
  })
})
