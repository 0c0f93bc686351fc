/** @typedef {{ message: string, code: string, pointer: string }} ErrorInfo   stable code and JSON pointer, or empty */

/** The message, code and pointer of anything thrown, as plain data. @param {unknown} error @returns {ErrorInfo} */
export function errorInfo(error) {
  if (!(error instanceof Error)) return { message: String(error), code: "", pointer: "" };
  const code = "code" in error && typeof error.code === "string" ? error.code : "";
  const pointer = "pointer" in error && typeof error.pointer === "string" ? error.pointer : "";
  return { message: error.message, code, pointer };
}
