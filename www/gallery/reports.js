/** The five reports. */
import { REPORT_1 } from "./report-1.js";
import { REPORT_2 } from "./report-2.js";
import { REPORT_3 } from "./report-3.js";
import { REPORT_4 } from "./report-4.js";
import { REPORT_5 } from "./report-5.js";

export const REPORTS = [REPORT_1, REPORT_2, REPORT_3, REPORT_4, REPORT_5];
