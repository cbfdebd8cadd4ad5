#!/usr/bin/env python3
"""What a short quell bench leaves: its page in headless Chromium (it loads without an error, shows every chart, switches
metric and method, and moves the slider), what --compare says of the same run, and the pictures of bench/plots:
report_page.py QUELL SEQUENCE"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SKIPPED = 77  # exit code that CTest takes for a skipped test

# Runs before the page's own scripts.
COLLECT = """<script>
window.problems = [];
window.addEventListener("error", event => problems.push(event.message));
window.addEventListener("unhandledrejection", event => problems.push(String(event.reason)));
for (const name of ["error", "warn"]) console[name] = (...words) => problems.push(words.join(" "));
</script>"""

# Runs after them; leaves what it found in the document.
DRIVE = """<script>
(async () => {
  const checks = {};
  const change = (id, value) => {
    byId(id).value = value;
    byId(id).dispatchEvent(new Event("change"));
  };
  const chart = name => document.querySelector(name).innerHTML;
  const wait = () => new Promise(done => setTimeout(done, 100));
  // Pictures are decoded aside, in real time.
  const until = async condition => {
    for (let i = 0; i < 100 && !condition(); ++i) await wait();
    return condition();
  };
  const canvas = document.querySelector("#comparer canvas");
  const pixels = () => canvas.toDataURL();
  await until(() => comparer && comparer.right);
  checks.charts = ["#pareto", "#stages", "#frame-times", "#sweeps"]
      .every(name => document.querySelector(name + " svg")) && byId("frame-errors").textContent.length > 0;
  checks.tables = document.querySelectorAll("#table tr").length === RESULTS.runs.length + 1 &&
      document.querySelectorAll("#model tr").length > 1 && document.querySelectorAll("#stages tr").length > 10;
  const before = chart("#pareto .chart");
  change("metric", "flip");
  checks.metric = chart("#pareto .chart") !== before && chart("#pareto .chart").includes("FLIP");
  const names = [...byId("right").options].map(option => option.value);
  checks.pictures = names.includes("noisy") && names.includes("reference") && names.length >= 4;
  const first = pixels();
  change("right", names.find(name => !["noisy", "reference", byId("right").value].includes(name)));
  checks.method = await until(() => pixels() !== first);
  const second = pixels();
  const slider = document.querySelector("#comparer input");
  slider.value = 100;
  slider.dispatchEvent(new Event("input"));
  const third = pixels();
  checks.slider = third !== second;
  canvas.dispatchEvent(new WheelEvent("wheel", {deltaY: -1, offsetX: 10, offsetY: 10, cancelable: true}));
  checks.zoom = comparer.view.scale > 1 && pixels() !== third;
  byId("difference").checked = true;
  byId("difference").dispatchEvent(new Event("change"));
  const shown = pixels();
  checks.difference = await until(() => pixels() !== shown);
  checks.problems = problems.length === 0 ? true : problems.join("; ");
  const result = document.createElement("pre");
  result.id = "checks";
  result.textContent = JSON.stringify(checks);
  document.body.append(result);
})();
</script>"""


def make_page(tool, sequence, folder):
    subprocess.run([tool, "bench", "--input", sequence, "--methods", "svgf,atrous", "--sweep", "taa", "--frames", "12",
                    "--repeat", "1", "--html", folder, "--json", folder + "/results.json"], check=True, capture_output=True)
    with open(folder + "/index.html") as file:
        page = file.read()
    assert not re.search(r"""(src|href)=["']?(https?:)?//""", page), "the page loads something from elsewhere"
    with open(folder + "/driven.html", "w") as file:
        file.write(page.replace("<body>", "<body>" + COLLECT).replace("</body>", DRIVE + "</body>"))


def check_comparison(tool, sequence, folder):
    """Outputs are deterministic: whatever the times, no figure of an equal run has changed."""
    said = subprocess.run([tool, "bench", "--input", sequence, "--methods", "atrous", "--frames", "12", "--repeat", "1",
                           "--compare", folder + "/results.json"], check=True, capture_output=True, text=True).stdout
    assert "1 runs compared: " in said and "; 0 figures worse, 0 better" in said, said


def check_plots(folder):
    plots = os.path.join(os.path.dirname(__file__), "../../bench/plots")
    subprocess.run([plots, folder + "/results.json", folder], check=True, capture_output=True)
    picture = xml.etree.ElementTree.parse(folder + "/pareto.svg")
    words = [node.text for node in picture.iter("{http://www.w3.org/2000/svg}text")]
    for word in ("svgf", "atrous", "unbiased RMSE"):
        assert word in words, words
    assert not os.path.exists(folder + "/skipping.svg"), "a picture without its runs"


def drive(browser, folder):
    """What the script in the page found, as JSON text; empty if it did not reach its end."""
    dump = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                           "--virtual-time-budget=20000", "--dump-dom", f"file://{folder}/driven.html"],
                          check=True, capture_output=True, text=True).stdout
    checks = re.search(r'<pre id="checks">(.*?)</pre>', dump)
    return checks.group(1) if checks else ""


def main():
    tool, sequence = sys.argv[1:]
    browser = shutil.which("chromium")
    with tempfile.TemporaryDirectory() as folder:
        make_page(tool, sequence, folder)
        check_comparison(tool, sequence, folder)
        check_plots(folder)
        if not browser:
            print("skipped: chromium is not installed (scripts/install-dependencies browser)")
            return SKIPPED
        checks = drive(browser, folder)
    print(checks or "the script in the page did not reach its end")
    return 0 if checks and "false" not in checks and '"problems":true' in checks else 1


if __name__ == "__main__":
    sys.exit(main())
