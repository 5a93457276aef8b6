"""What the top level says of a release must agree: CITATION.cff, CHANGELOG.md and CMakeLists.txt.

usage: release_facts.py FOLDER; exit status 77 without python3-yaml."""

import pathlib
import re
import sys

try:
    import yaml
except ImportError:
    print("release_facts: needs python3-yaml")
    sys.exit(77)

# Of the Citation File Format 1.2.0.
required = {"cff-version", "message", "title", "authors"}
optional = {"abstract", "commit", "contact", "date-released", "doi", "identifiers", "keywords", "license", "license-url",
            "preferred-citation", "references", "repository", "repository-artifact", "repository-code", "type", "url",
            "version"}


def complaints(folder):
    citation = yaml.safe_load((folder / "CITATION.cff").read_text())
    for key in sorted(required - citation.keys()):
        yield f"CITATION.cff lacks {key}"
    for key in sorted(citation.keys() - required - optional):
        yield f"CITATION.cff has {key}, which CFF 1.2.0 does not know"
    if citation.get("cff-version") != "1.2.0":
        yield "CITATION.cff is not of CFF 1.2.0"
    if citation.get("type", "software") not in ("software", "dataset"):
        yield f"CITATION.cff cites a {citation['type']}: it must be software or dataset"
    for work in [citation, *citation.get("references", [])]:
        for author in work.get("authors") or [{}]:
            if "name" not in author and "family-names" not in author:
                yield f"CITATION.cff: an author of '{work.get('title')}' has no name"
    for reference in citation.get("references", []):
        if not {"type", "title", "authors"} <= reference.keys():
            yield "CITATION.cff: a reference lacks its type, title or authors"

    version = re.search(r"^project\(gpf VERSION ([0-9.]+)", (folder / "CMakeLists.txt").read_text(), re.M)[1]
    newest = re.search(r"^## (?:Unreleased: )?([0-9]+\.[0-9]+\.[0-9]+)", (folder / "CHANGELOG.md").read_text(), re.M)
    for file, found in (("CITATION.cff", citation.get("version")), ("CHANGELOG.md", newest and newest[1])):
        if found != version:
            yield f"{file} is of version {found}, CMakeLists.txt of {version}"


found = list(complaints(pathlib.Path(sys.argv[1])))
print("\n".join(found) or "versions and citation agree")
sys.exit(bool(found))
