"""Pages of `gpf view` in a real browser: they load from disk, play, and complain about nothing.

usage: view_test.py GPF WORKDIR; exit status 77 without Chromium, or when gpf was built without its plots."""
import pathlib
import shutil
import subprocess
import sys
import zlib

import chromium

SCENE = """[scene]
geometry = "{geometry}"
particles = {particles}
area_fraction = 0.3
{size}
normal_restitution = 0.9
{walls}
[run]
start_up = 2
duration = 4
density_modes = {modes}
"""
FRAMES = 60
passed = 0


def check(condition, what, fact=""):
    global passed
    if not condition:
        sys.exit(f"FAILED: {what} {fact}")
    passed += 1
    print(f"ok {passed} - {what}")


def variety(png):
    """Number of different values among the bytes of a PNG's pixels (as filtered): 1 or 2 for a blank picture."""
    pixels, at = b"", 8
    while at < len(png):
        length, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        if kind == b"IDAT":
            pixels += png[at + 8:at + 8 + length]
        at += length + 12
    return len(set(zlib.decompress(pixels)))


def drawn(page, canvas):
    """Whether a canvas holds different colours."""
    return page.value(f"""(() => {{
      const canvas = document.querySelector({canvas!r});
      const copy = new OffscreenCanvas(canvas.width, canvas.height), pen = copy.getContext("2d");
      pen.drawImage(canvas, 0, 0);
      const pixels = pen.getImageData(0, 0, canvas.width, canvas.height).data;
      return new Set(new Uint32Array(pixels.buffer)).size > 5;
    }})()""")


def frame(page):
    return int(page.value("document.documentElement.dataset.frame"))


def try_page(html, work, narrow, plots):
    page = chromium.Page(html.as_uri(), work / "profile", 1280, 900)
    try:
        check(page.wait_for("document.documentElement.dataset.frame === '0'"), f"{html.name} loads", page.complaints)
        check(drawn(page, "#channel") and drawn(page, "#spectrum"), "disks and spectrum are drawn")
        check(page.value("document.querySelectorAll('.uplot').length") == plots, f"{plots} plots")
        for _ in range(4):
            page.press("ArrowDown", 40)
        check(page.value("document.getElementById('speed').value") == "5", "arrows change the speed")
        page.press(" ", 32)
        check(page.wait_for("document.documentElement.dataset.frame > 3"), "space plays")
        page.press(" ", 32)
        stood = frame(page)
        page.press("ArrowRight", 39)
        page.press("ArrowRight", 39, shift=True)
        check(frame(page) == min(FRAMES - 1, stood + 11), "arrows step")
        page.press("Home", 36)
        page.press("ArrowLeft", 37)
        check(frame(page) == 0, "no frame before the first")
        for _ in range(4):
            page.press("ArrowUp", 38)
        page.press("End", 35)
        page.value("document.getElementById('play').click()")
        check(page.wait_for(f"document.documentElement.dataset.frame == {FRAMES - 1} && "
                            "document.getElementById('play').textContent === 'Play'"), "it plays again and ends")
        for colouring in ("fluctuation", "one", "speed"):
            page.value(f"document.getElementById('colouring').value = '{colouring}';"
                       "document.getElementById('colouring').dispatchEvent(new Event('change'))")
            check(drawn(page, "#channel") or colouring == "one", f"colour by {colouring}")
        page.value("document.getElementById('along').click()")
        check(drawn(page, "#channel"), "it is seen by one who moves with the flow")
        page.value("document.getElementById('about').open = true")
        check(page.value("document.querySelectorAll('#tables td').length") > 20, "scene and provenance are told")
        check(not page.value("window.hostile"), "no script of the record has run")
        for width in (1280, narrow):
            page.resize(width, 900)
            check(page.wait_for(f"document.documentElement.scrollWidth <= {width} && "
                                f"document.getElementById('channel').clientWidth <= {width}"), f"it fits {width} pixels")
            picture = page.screenshot()
            (work / f"{html.stem}-{width}.png").write_bytes(picture)
            check(variety(picture) > 100, "the picture is not blank")
        check(not page.complaints, "the browser complains about nothing", page.complaints)
    finally:
        page.close()


def main():
    gpf, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    if chromium.find() is None:
        print("skipped: no Chromium")
        return 77
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    hostile = work / "<img src=x onerror=hostile=1>.toml"
    channel = SCENE.format(geometry="channel", particles=300, size="width_over_diameter = 20",
                           walls="wall_tangential_restitution = 0.9", modes=4)
    hostile.write_text(channel + "# </script><script>hostile = 1</script>\n")
    page = work / "channel.html"
    call = [gpf, "view", str(hostile), "-o", str(page), "--frames", str(FRAMES)]
    made = subprocess.run(call, capture_output=True, text=True)
    if "without the plotting library" in made.stderr:
        print("skipped: gpf was built without its plots")
        return 77
    check(made.returncode == 0, "a page of a scene", made.stderr)
    try_page(page, work, 700, 5)

    scene = work / "periodic.toml"
    scene.write_text(SCENE.format(geometry="periodic", particles=800, size="length_over_width = 5", walls="", modes=0))
    subprocess.run([gpf, "run", scene, "-o", work / "periodic.h5"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([gpf, "view", work / "periodic.h5", "--frames", str(FRAMES)], check=True, stdout=subprocess.DEVNULL)
    try_page(work / "periodic.html", work, 700, 4)
    print(f"{passed} checks passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
