/** Version of the package, the same as that of the crate inside it. @type {string} */
export const version = "0.2.0";
