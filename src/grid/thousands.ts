/** "1,234.5" for "1234.5". @param digits with three decimals at most */
export const inThousands = (digits: string): string => digits.replace(/\B(?=(\d{3})+(\.|$))/g, ',')
