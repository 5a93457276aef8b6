"""The runner of documents must be able to fail. usage: runner_test.py SCRATCH"""
import pathlib
import sys

import run_document

SCRATCH = pathlib.Path(sys.argv[1])
SOURCE = SCRATCH / "source"  # stands for the repository
GOOD = """A file `a/b.toml`:

```toml
x = 1
```

    cat a/b.toml          # an indented command
    cd a && export WORD=yes

<!-- test: numbers differ -->
```console
$ echo "$WORD 7"; \\
  echo tail 0123456789abcdef; ls
yes 8.5e-3
...
b.toml
```

<!-- test: exit 3 -->
```sh
true
(exit 3)
```

<!-- test: skip, it would
take an hour -->

    sleep 3600

<!-- test: skip "sleep", long -->
```console
$ sleep 3600
$ echo done
done
```

Part of `tests/part.py`:

```python
b = 2
```

```text
nothing
```
"""
BAD = {
    "status": ("    false\n", "exit status 1, not 0"),
    "status wanted": ("<!-- test: exit 2 -->\n```sh\ntrue\n```\n", "exit status 0, not 2"),
    "output": ("```console\n$ echo a\nb\n```\n", "other output"),
    "more output": ("```console\n$ echo a; echo b\na\n```\n", "other output"),
    "number": ("```console\n$ echo 1\n2\n```\n", "other output"),
    "hash": ("<!-- test: numbers differ -->\n```console\n$ echo 0123456789abcdef\n0123456789abcdee\n```\n", "other output"),
    "no name": ("```toml\nx = 1\n```\n", "has no name"),
    "outside": ("The file `../x`:\n\n```toml\nx = 1\n```\n", "has no name"),
    "other than the file": ("See `README.md`:\n\n```toml\nx = 1234567\n```\n", "no part of README.md"),
    "unknown annotation": ("<!-- test: slow -->\n\n    true\n", "unknown annotation 'slow'"),
    "skip without reason": ("<!-- test: skip -->\n\n    true\n", "unknown annotation 'skip'"),
    "skips nothing": ('<!-- test: skip "sleep", long -->\n\n    true\n', "no command begins"),
    "annotation of nothing": ("<!-- test: exit 1 -->\n\ntext\n", "stands above no block"),
    "open block": ("```sh\ntrue\n", "without its end"),
}


def follow(text):
    document = SCRATCH / "document.md"
    document.write_text(text)
    return run_document.follow(document, SOURCE, SCRATCH, SCRATCH / "run")


for part in ("reference", "reports", "tests"):
    (SOURCE / part).mkdir(parents=True, exist_ok=True)
(SOURCE / "README.md").write_text("a readme\n")
(SOURCE / "tests" / "part.py").write_text("a = 1\nb = 2\nc = 3\n")
reader = follow(GOOD)
counts = (reader.ran, reader.skipped, reader.written, reader.compared)
if counts != (6, 2, 1, 1):
    sys.exit(f"FAILED: counted {counts}")
for name, (text, complaint) in BAD.items():
    try:
        follow(text)
    except run_document.Failure as failure:
        if complaint not in str(failure):
            sys.exit(f"FAILED: {name}: complains of '{failure}'")
    else:
        sys.exit(f"FAILED: {name}: nothing found")
print(f"{len(BAD)} faults found")
