"""Runs isl and POV-Ray 3.7 on one scene, each with one thread and one ray a pixel. Imported by the scripts of this folder."""
import os
import re
import resource
import shutil
import subprocess
import sys

ISL = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../build/release/bin/isl')
INCLUDES = '/usr/share/povray-3.7/include'


def add_program_options(parser):
    parser.add_argument('--isl', default=os.environ.get('ISL', ISL), help='the program isl [build/release/bin/isl, or $ISL]')
    parser.add_argument('--povray', default='povray', help='the program povray 3.7 [povray]')
    parser.add_argument('--include', default=INCLUDES, help=f"POV-Ray's include files [{INCLUDES}]")


def find_programs(options):
    """Makes the paths of both programs absolute, or ends the script with what is missing."""
    for name, hint in ('isl', "build it with './isl --version', or say where it is with --isl"), (
            'povray', 'install povray 3.7, or say where it is with --povray'):
        found = shutil.which(getattr(options, name))
        if not found:
            sys.exit(f'{os.path.basename(sys.argv[0])}: no program {getattr(options, name)}: {hint}')
        setattr(options, name, os.path.abspath(found))


class Ran:
    """What a command left: `code` (None after a timeout), standard `output`, `errors`, processor `seconds` on all cores."""

    def __init__(self, command, folder, timeout):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            process = subprocess.run(command, capture_output=True, timeout=timeout, stdin=subprocess.DEVNULL, cwd=folder)
            self.code, output, errors = process.returncode, process.stdout, process.stderr
        except subprocess.TimeoutExpired as expired:
            self.code, output, errors = None, expired.stdout or b'', expired.stderr or b''
        except OSError as error:
            sys.exit(f'{os.path.basename(sys.argv[0])}: cannot start {command[0]}: {error.strerror}')
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.output = output.decode('utf8', 'replace')
        self.errors = errors.decode('utf8', 'replace')
        self.seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_isl(options, scene, picture, size, *arguments, folder=None, timeout=120):
    return Ran([options.isl, 'render', scene, '-o', picture, '-s', '{}x{}'.format(*size), '-t', '1', '--samples', '1', '-q',
                *arguments], folder, timeout)


def run_povray(options, scene, picture, size, *arguments, folder=None, timeout=120):
    return Ran([options.povray, f'+I{scene}', f'+O{picture}', f'+W{size[0]}', f'+H{size[1]}', '-D', '-A', '-P', '+WT1',
                f'+L{options.include}', *arguments], folder, timeout)


def isl_message(ran):
    """The first error, without its place; what the program does not have is preferred to nothing else."""
    messages = re.findall(r'error: (.*)', ran.errors)
    return messages[0] if messages else ran.errors.strip()[-200:] or describe(ran)


def is_refusal(message):
    """Whether isl says that it does not have something."""
    return bool(re.search(r' (is|are) not (supported|rendered)', message))


def povray_message(ran):
    """The first error, which POV-Ray breaks over lines that begin with a blank."""
    found = re.search(r'(?:Parse Error|Fatal error)[^\n:]*:\s*([^\n]+(?:\n [^\n]+)*)', ran.errors)
    return ' '.join(found.group(1).split())[:200] if found else describe(ran)


def describe(ran):
    return 'timed out' if ran.code is None else f'exit code {ran.code}'
