"""Writes tests/statistics.json: samples with the statistics that NumPy and SciPy give for them."""
import json, math, sys
import numpy as np, scipy
from scipy import stats

rng = np.random.default_rng(1)
def none(x): return [None if math.isnan(v) else v for v in x]

samples = {
    "five": [6.1, 7.9, 5.2, 6.6, 4.83],
    "two": [1.0, 2.5],
    "ties": [3.0, 1.0, 2.0, 2.0, 5.0, 3.0, 3.0, 9.0],
    "failures": [0.25, math.nan, 1.5, 0.75, math.nan, 0.75, 2.0],
    "lognormal": list(np.round(rng.lognormal(3, 0.7, 100), 6)),
    "counts": [float(v) for v in rng.poisson(40, 300)],
}
def needed(values):
    m, s = np.mean(values), np.std(values, ddof=1)
    n = 2
    while stats.t.ppf(0.975, n - 1) * s / math.sqrt(n) > 0.05 * abs(m): n += 1
    return n
out = {"numpy": np.__version__, "scipy": scipy.__version__, "shares": [], "samples": [], "pairs": [], "averages": []}
for count, n in [(0, 5), (5, 5), (3, 5), (81, 100), (1798, 1800), (1, 1), (37, 150)]:
    ci = stats.binomtest(count, n).proportion_ci(0.95, method="wilson")
    out["shares"].append({"count": count, "n": n, "low": ci.low, "high": ci.high})
for name, sample in samples.items():
    values = [v for v in sample if not math.isnan(v)]
    low, high = stats.t.interval(0.95, len(values) - 1, loc=np.mean(values), scale=stats.sem(values))
    e = stats.ecdf(values).cdf
    out["samples"].append({"name": name, "sample": none(sample),
        "quartiles": list(np.percentile(values, [0, 25, 50, 75, 100], method="linear")),
        "mean": np.mean(values), "deviation": np.std(values, ddof=1), "low": low, "high": high, "needed": needed(values),
        "ecdf": [list(e.quantiles), list(e.probabilities * len(values) / len(sample))]})
for width, name in [(20, "lognormal"), (3, "ties")]:
    out["averages"].append({"sample": samples[name], "width": width,
        "average": list(np.convolve(samples[name], np.ones(width) / width, "valid"))})
def pair(name, a, b, method):
    a, b = np.array(a, float), np.array(b, float)
    ok = ~(np.isnan(a) | np.isnan(b)); d = (a - b)[ok]
    small, large = int((d < 0).sum()), int((d > 0).sum())
    w = stats.wilcoxon(d, zero_method="wilcox", correction=False, method=method)
    out["pairs"].append({"name": name, "a": none(a), "b": none(b), "smaller": small, "larger": large, "median": float(np.median(d)),
        "sign_p": stats.binomtest(min(small, large), small + large).pvalue, "wilcoxon_p": w.pvalue})
every = stats.PermutationMethod(n_resamples=np.inf)
a = rng.normal(0, 1, 8).round(4); pair("eight", a, rng.normal(0.6, 1, 8).round(4), "exact")
a = rng.normal(0, 1, 50).round(6); pair("fifty", a, a + rng.normal(0.3, 1, 50).round(6), "exact")
a = rng.normal(0, 1, 51).round(6); pair("fifty-one", a, a + rng.normal(0.3, 1, 51).round(6), "asymptotic")
a = rng.normal(0, 1, 400).round(6); pair("four hundred", a, a + rng.normal(0.1, 1, 400).round(6), "asymptotic")
pair("ties, few", [7, 8, 9, 7, 8, 9, 9, 6, 7, 8, 5, 9], [8, 8, 9, 9, 10, 12, 8, 7, 9, 9, 9, 9], every)
a = rng.poisson(8, 90); pair("ties, many", a, rng.poisson(9, 90), "asymptotic")
a = rng.lognormal(2, 1, 12).round(3); b = (a * rng.lognormal(0.4, 0.5, 12)).round(3); a[3] = math.nan; b[7] = math.nan
pair("missing", a, b, "exact")
def text(value): return json.dumps(value, separators=(",", ":"), default=float)
# One case a line.
fields = [f'"{name}":[\n' + ",\n".join(map(text, value)) + "\n]" if isinstance(value, list) else f'"{name}":{text(value)}' for name, value in out.items()]
open(sys.argv[1], "w").write("{\n" + ",\n".join(fields) + "\n}\n")
