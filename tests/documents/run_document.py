"""Does what a document tells its reader to do, and checks what it shows.

usage: run_document.py DOCUMENT SOURCE BUILD SCRATCH

In a scratch folder that looks like the repository, with BUILD's programs on the PATH, in the document's order:
- indented blocks and ```sh: each command is run and must succeed;
- ```console: so is each line after "$ ", and what it prints (both streams) must be the lines below it; a line "..."
  stands for any number of lines;
- blocks in any other language are files. The paragraph above ends with the name, in backquotes, and a colon. If the
  repository has that file, the block must be a part of it; else the block is written under that name;
- ```text is for readers only.

An annotation, <!-- test: WHAT -->, stands above its block. WHAT is one of
  skip, REASON                  the commands of the block are not run
  skip "BEGINNING", REASON      nor are those of its commands that begin so
  exit N                        the last command of the block ends with this status
  numbers differ                in what is shown any number stands for any other; 16 hexadecimal digits do not
Anything else is an error: so nothing goes untested without a reason."""
import os
import pathlib
import re
import shutil
import subprocess
import sys


class Failure(Exception):
    pass


class Block:
    def __init__(self, language, line, lines, name, annotations):
        self.language, self.line, self.lines, self.name = language, line, lines, name
        self.exit_status, self.numbers_differ, self.skipped, self.skip_beginnings = 0, False, "", []
        for annotation in annotations:
            self.annotate(annotation)

    def annotate(self, text):
        if match := re.fullmatch(r'skip "([^"]+)", (\S.*)', text):
            self.skip_beginnings.append(match[1])
        elif match := re.fullmatch(r"skip, (\S.*)", text):
            self.skipped = match[1]
        elif match := re.fullmatch(r"exit (\d+)", text):
            self.exit_status = int(match[1])
        elif text == "numbers differ":
            self.numbers_differ = True
        else:
            raise Failure(f"line {self.line}: unknown annotation '{text}'")

    def commands(self):
        """Pairs of a command and the lines that it must print, None where the document does not say."""
        found, going_on = [], False
        for line in self.lines:
            if self.language != "console":
                if going_on:
                    found[-1][0] += "\n" + line
                elif line.strip() and not line.lstrip().startswith("#"):
                    found.append([line, None])
            elif going_on:
                found[-1][0] += "\n" + line
            elif line.startswith("$ "):
                found.append([line[2:], []])
            elif found:
                found[-1][1].append(line)
            else:
                raise Failure(f"line {self.line}: output before the first command")
            going_on = line.endswith("\\") and (going_on or self.language != "console" or line.startswith("$ "))
        return found


def blocks_of(text):
    """The blocks of a document, in order. Raises Failure."""
    blocks, annotations, paragraph = [], [], ""
    lines = text.split("\n")
    at = 0
    while at < len(lines):
        line = lines[at]
        if line.startswith("<!-- test:"):
            comment = line
            while "-->" not in comment:
                at += 1
                if at == len(lines):
                    raise Failure("an annotation without its end")
                comment += " " + lines[at].strip()
            annotations.append(re.fullmatch(r"<!-- test:\s*(.*?)\s*-->", comment)[1])
            at += 1
            continue
        fence = re.match(r"(`{3,})(.*)$", line)
        indented = line.startswith("    ") and (at == 0 or not lines[at - 1].strip() or "-->" in lines[at - 1])
        if not fence and not indented:
            if line.strip():
                paragraph = line
            at += 1
            continue
        first, content = at + 1, []
        if fence:
            language = fence[2].strip()
            at += 1
            while at < len(lines) and lines[at] != fence[1]:
                content.append(lines[at])
                at += 1
            if at == len(lines):
                raise Failure(f"line {first}: a block without its end")
            at += 1
        else:
            language = "sh"
            while at < len(lines) and (lines[at].startswith("    ") or not lines[at].strip()):
                content.append(lines[at][4:])
                at += 1
        while content and not content[-1].strip():
            content.pop()
        name = re.search(r"`([^`\s]+)`:$", paragraph.rstrip())
        blocks.append(Block(language, first, content, name[1] if name else "", annotations))
        annotations, paragraph = [], ""
    if annotations:
        raise Failure(f"the annotation '{annotations[-1]}' stands above no block")
    return blocks


def comparable(line, numbers_differ):
    line = re.sub(r"\s+", " ", line.rstrip())
    if not numbers_differ:
        return line
    line = re.sub(r"\b[0-9a-f]{16}\b|(?<![A-Za-z_])[-+]?\d+(\.\d+)?(e[-+]?\d+)?",
                  lambda m: m[0] if re.fullmatch("[0-9a-f]{16}", m[0]) else "#", line)
    return re.sub(r"-{3,}", "---", line)


def matches(shown, printed):
    """Whether the lines are those shown; "..." is any number of lines."""
    reached = {0}  # how many of the lines printed may have been used up
    for line in shown:
        if line == "...":
            reached = set(range(min(reached), len(printed) + 1)) if reached else reached
        else:
            reached = {k + 1 for k in reached if k < len(printed) and printed[k] == line}
    return len(printed) in reached


class Reader:
    """Follows a document."""

    def __init__(self, source, build, scratch):
        self.source, self.scratch, self.folder = source, scratch, scratch / "gpf"
        self.ran = self.skipped = self.written = self.compared = 0
        shutil.rmtree(scratch, ignore_errors=True)
        self.folder.mkdir(parents=True)
        for path in source.iterdir():  # a copy of what a command may write to, links to the rest
            if path.is_file():
                shutil.copy(path, self.folder)
            elif path.name in ("reference", "reports"):
                shutil.copytree(path, self.folder / path.name)
            elif path.name in (".ci", ".github", "lib", "tests", "verify"):
                (self.folder / path.name).symlink_to(path)
        (self.folder / "build").mkdir()
        (self.folder / "build" / "release").symlink_to(build)
        self.environment = dict(os.environ, PATH=f"{build / 'verify'}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
        self.state = scratch / "state"
        self.state.write_text(f"cd '{self.folder}'\n")

    def run(self, command):
        """Exit status and output. The folder and the variables are those that the command before left."""
        script = f". '{self.state}'\n{command}\nstatus=$?\n{{ export -p; echo \"cd '$PWD'\"; }} > '{self.state}'\nexit $status"
        done = subprocess.run(["bash", "-c", script], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env=self.environment, check=False)
        return done.returncode, done.stdout.decode(errors="replace")

    def follow(self, block):
        if block.language in ("sh", "console"):
            self.follow_commands(block)
        elif block.language != "text":
            self.follow_file(block)

    def follow_commands(self, block):
        commands, unused = block.commands(), set(block.skip_beginnings)
        for k, (command, shown) in enumerate(commands):
            beginning = next((b for b in block.skip_beginnings if command.startswith(b)), None)
            unused.discard(beginning)
            if block.skipped or beginning:
                self.skipped += 1
                print(f"skipped: {command}")
                continue
            print(f"$ {command}", flush=True)
            status, output = self.run(command)
            self.ran += 1
            wanted = block.exit_status if k + 1 == len(commands) else 0
            if status != wanted:
                raise Failure(f"line {block.line}: exit status {status}, not {wanted}, of\n{command}\n{output}")
            printed = output.rstrip("\n").split("\n") if output.strip() else []
            while shown and not shown[-1].strip():
                shown.pop()
            if shown is not None and not matches([comparable(line, block.numbers_differ) for line in shown],
                                                 [comparable(line, block.numbers_differ) for line in printed]):
                raise Failure(f"line {block.line}: other output than shown, of\n{command}\n" + "\n".join(printed))
        if unused:
            raise Failure(f"line {block.line}: no command begins with '{unused.pop()}'")

    def follow_file(self, block):
        if not block.name or ".." in block.name or block.name.startswith("/"):
            raise Failure(f"line {block.line}: a block in '{block.language}' whose file has no name")
        text = "\n".join(block.lines) + "\n"
        original = self.source / block.name
        if original.exists():
            if text not in original.read_text():
                raise Failure(f"line {block.line}: this is no part of {block.name}")
            self.compared += 1
            return
        path = self.folder / block.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        self.written += 1


def follow(document, source, build, scratch):
    """Raises Failure where the document is wrong. Returns the reader, who has counted."""
    blocks = blocks_of(pathlib.Path(document).read_text())
    reader = Reader(pathlib.Path(source).resolve(), pathlib.Path(build).resolve(), pathlib.Path(scratch).resolve())
    for block in blocks:
        reader.follow(block)
    return reader


if __name__ == "__main__":
    try:
        r = follow(*sys.argv[1:5])
    except Failure as failure:
        sys.exit(f"FAILED: {sys.argv[1]}: {failure}")
    print(f"{r.ran} commands run, {r.skipped} skipped, {r.written} files written, {r.compared} compared")
    shutil.rmtree(r.scratch)
