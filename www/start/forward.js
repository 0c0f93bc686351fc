/**
 * The planner's page was `index.html`: its links, of a run or a lesson, and frames with `?embed` open at its address
 * now. A script of its own, so that this happens before anything is drawn.
 */
{
  const forward = () => {
    const { search, hash } = location;
    if (/^#(\d|lesson=)/.test(hash) || new URLSearchParams(search).has("embed"))
      location.replace(`plan.html${search}${hash}`);
  };
  forward();
  addEventListener("hashchange", forward);
}
