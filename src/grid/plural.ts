/** "cell" for one of them, else "cells". */
export const plural = (count: number, what: string): string => (count === 1 ? what : `${what}s`)
