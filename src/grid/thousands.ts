/** "1,234.5" for "1234.5". Only the whole part is set apart, however many decimals there are. */
export const inThousands = (digits: string): string =>
  digits.replace(/^-?\d+/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ','))
