"""The commands for GDB that chapter 25 and the README give, typed as they stand there, and whether it answers as they say:

    gdb -batch -nx -x crevice_gdb.py -x page_commands_test.py --args crevice_to_step
"""

import os
import re
import shlex
import signal
import subprocess
import tempfile

import gdb

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
program = gdb.current_progspace().filename
failures = []


def require(holds, what):
    if not holds:
        failures.append(what)
    return holds


def columns(line):
    """Whatever is between them: an answer is as wide as all of its rows, on a page as one of them."""
    return line.split()


def started(words):
    """From the words with which GDB is started: the same in this GDB, with the program that is tested."""
    expected = "gdb -x chapters/debugger/crevice_gdb.py --args build/debug/crevice".split()
    require(words[:5] == expected, f"not how GDB is started: {words}")
    gdb.execute("set args " + " ".join(map(shlex.quote, words[5:])))


def answer(command):
    """The lines that a command prints, and the one about a signal, which GDB prints beside them."""
    lines = gdb.execute(command, to_string=True).splitlines()
    if command == "run" and gdb.selected_inferior().pid != 0:
        number = signal.Signals(int(gdb.parse_and_eval("$_siginfo.si_signo")))
        lines.append(f"Program received signal {number.name}, {signal.strsignal(number)}.")
    return lines


def typed_and_said(text):
    """[(command, lines below it), ...] of a transcript; dots stand for lines that it leaves out."""
    sessions = []
    for line in text.replace("\\\n", " ").splitlines():
        prompt = re.match(r"(?:\$|\(gdb\)) (.*)", line)
        if prompt:
            sessions.append((prompt.group(1), []))
        elif line != "...":
            sessions[-1][1].append(line)
    return sessions


def check_transcript(what, text):
    (start, _), *commands = typed_and_said(text)
    started(shlex.split(start))
    require([command.split()[0] for command, _ in commands] == ["run", "pixel", "next", "print"], f"{what}: other commands")
    for command, lines in commands:
        answers = list(map(columns, answer(command)))
        for line in lines:
            # GDB counts what it prints.
            said = columns(re.sub(r"^\$\d+ = ", "", line))
            require(any(one == said or one[2:] == said for one in answers), f"{what}: after `{command}` no line {line!r}")
    gdb.execute("kill")


def check_chapter():
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "chapter", "25", "--size", "160x90", "--lang", "en", "--quiet", "--out", out], check=True)
        with open(os.path.join(out, "25_guilty_sample", "25_guilty_sample.md"), encoding="utf-8") as page:
            transcripts = re.findall(r"```console\n(\$ gdb .*?)```", page.read(), re.DOTALL)
    require(len(transcripts) == 3, f"{len(transcripts)} transcripts of GDB in chapter 25")
    for number, text in enumerate(transcripts):
        check_transcript(f"chapter 25, transcript {number}", text)


def check_readme():
    """Its comments say what there is to see."""
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        block = re.search(r"^    gdb -x .*?(?=^\S)", file.read(), re.DOTALL | re.MULTILINE).group(0)
    start, *lines = [line.strip() for line in block.replace("\\\n", " ").strip().splitlines()]
    started(shlex.split(start))
    commands = [re.fullmatch(r"\(gdb\) (.*?) +# (.*)", line).groups() for line in lines]
    require([command.split()[0] for command, _ in commands] == ["run", "pixel", "next", "print"], "README: other commands")
    for command, comment in commands:
        answers = answer(command)
        if command.startswith("pixel "):
            value = next(columns(line)[-1] for line in answers if line.startswith("worked.raw.ao "))
            require(f"{float(value):.2f}" in comment, f"README: {value} after `{command}`, its comment says {comment!r}")
        if command == "print told":
            taking = re.findall(r"^\[(\d+)\] +takes (?!0 )", "\n".join(answers), re.MULTILINE)
            require(" and ".join(taking) in comment, f"README: {taking} take something, its comment says {comment!r}")
    gdb.execute("kill")


for setting in ("confirm off", "pagination off", "width 0", "environment ASAN_OPTIONS detect_leaks=0"):
    gdb.execute(f"set {setting}")
check_chapter()
check_readme()
for failure in failures:
    print(failure)
print(f"{len(failures)} failures")
gdb.execute(f"quit {1 if failures else 0}")
