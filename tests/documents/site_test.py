"""The pages of `gpf report --html`: complete, valid, linked, and without HTML from texts.

usage: site_test.py GPF SOURCE SCRATCH; exit status 77 without cmark-gfm."""
import html.parser
import pathlib
import shutil
import subprocess
import sys
import urllib.parse

VOID = {"meta", "img", "br", "hr", "link", "input"}
HARMLESS = {"a", "blockquote", "body", "br", "code", "del", "details", "em", "h1", "h2", "h3", "h4", "head", "hr", "html",
            "img", "li", "main", "meta", "nav", "ol", "p", "pre", "strong", "style", "summary", "table", "tbody", "td",
            "th", "thead", "title", "tr", "ul"}


class Page(html.parser.HTMLParser):
    """Links of a page; raises ValueError where tags are not closed in order, or are none that a page may have."""

    def __init__(self, text):
        super().__init__()
        self.open, self.links, self.text = [], [], ""
        self.feed(text)
        self.close()
        if self.open:
            raise ValueError(f"not closed: {self.open}")

    def handle_starttag(self, tag, attrs):
        if tag not in HARMLESS:
            raise ValueError(f"a tag <{tag}>")
        for name, value in attrs:
            if name.startswith("on"):
                raise ValueError(f"an attribute {name}")
            if name in ("href", "src"):
                self.links.append(value)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes nothing")

    def handle_data(self, data):
        self.text += data


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def site(gpf, reports, reference, output):
    shutil.rmtree(output, ignore_errors=True)
    return subprocess.run([gpf, "report", "--html", output, "--output", reports, "--reference", reference],
                          capture_output=True, text=True, check=False)


def pages_of(folder):
    return {path.relative_to(folder): Page(path.read_text()) for path in folder.rglob("*.html")}


def whole_site(gpf, source, output):
    done = site(gpf, source / "reports", source / "reference", output)
    check(done.returncode == 0, done.stderr)
    check(done.stdout.strip() == str(output / "index.html"), done.stdout)
    pages = pages_of(output)
    for path, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or not url.path:
                check(url.scheme in ("", "http", "https", "mailto"), f"{path} links to {link}")
                continue
            target = (output / path.parent / urllib.parse.unquote(url.path)).resolve()
            check(target.is_file() and output in target.parents, f"{path} links to {link}, which is not there")
            check(target.suffix != ".md", f"{path} links to markdown, {link}")
    texts = {path.relative_to(source) for part in ("reports", "reference/guide", "reference/claims")
             for path in (source / part).rglob("*.md")} | {pathlib.Path("README.md"), pathlib.Path("CHANGELOG.md")}
    made = {path.with_suffix(".md") for path in pages} - {pathlib.Path("index.md")}
    check(texts <= made, f"without a page: {texts - made}")
    check(all((source / path).is_file() for path in made), f"pages of nothing: {[p for p in made if not (source / p).is_file()]}")
    index = {link for link in pages[pathlib.Path("index.html")].links}
    check({str(path.with_suffix(".html")) for path in made} <= index, "the index lists not all pages")
    pictures = [link for page in pages.values() for link in page.links if link.endswith(".svg")]
    check(len(pictures) > 100, "there are no pictures")
    print(f"{len(pages)} pages of {len(made)} texts, {sum(len(p.links) for p in pages.values())} links")


HOSTILE = """# A <script>alert(1)</script> & title

<script>alert(2)</script>
<img src=x onerror=alert(3)> [a](javascript:alert(4)) [b](data:text/html,x) ![c](VBSCRIPT:x)
[d](<https://e.org/"onclick=alert(5)>) <details><a href="javascript:alert(6)">

<details>
<summary>All <b>1</b> checks</summary>

| a | b |
|---|---|
| <iframe src="x"> | `<b>` |

</details>

<details>
<summary>All 12 checks</summary>

text
"""


def hostile_site(gpf, scratch):
    reports = scratch / "reports"
    shutil.rmtree(scratch, ignore_errors=True)
    (scratch / "reference").mkdir(parents=True)
    reports.mkdir()
    (reports / "README.md").write_text(HOSTILE)
    done = site(gpf, reports, scratch / "reference", scratch / "site")
    check(done.returncode == 0, done.stderr)
    page = pages_of(scratch / "site")[pathlib.Path("reports/README.html")]
    check(not [link for link in page.links if "script" in link.lower() or link.startswith("data")], f"{page.links}")
    check("All 12 checks" in page.text and "<b>" in page.text, "what is harmless is shown")
    (reports / "README.md").write_text("[a](gone.md)\n")
    done = site(gpf, reports, scratch / "reference", scratch / "site")
    check(done.returncode == 2 and "links to 'gone.md'" in done.stderr, done.stderr)
    (scratch / "outside.txt").write_text("secret")
    (reports / "README.md").write_text("[a](../../outside.txt)\n")
    done = site(gpf, reports, scratch / "reference", scratch / "site")
    check(done.returncode == 2 and "links to" in done.stderr, done.stderr)
    (reports / "README.md").unlink()
    done = site(gpf, reports, scratch / "reference", scratch / "site")
    check(done.returncode == 2 and "no page" in done.stderr, done.stderr)


if __name__ == "__main__":
    if shutil.which("cmark-gfm") is None:
        print("no cmark-gfm: skipped")
        sys.exit(77)
    program, source_folder, scratch_folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    for wrong in ("<p>", "<p></b>", "<script></script>", "<p onclick='x'></p>"):
        try:
            Page(wrong)
        except ValueError:
            continue
        sys.exit(f"FAILED: {wrong} passes for a page")
    hostile_site(program, scratch_folder / "hostile")
    whole_site(program, source_folder, scratch_folder / "site")
