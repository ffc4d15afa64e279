#!/usr/bin/env python3
"""The files of stdlib/ that have the names of POV-Ray 3.7's include files, compared with those: does a scene find in
ours what it asks for?

    bench/standard_files.py [FILE…] [--page PAGE.png] [--stdlib FOLDER] [--isl PROGRAM] [--povray PROGRAM] [--include
    FOLDER]

FILE is a file's name without `.inc`; all are compared if none is given. For each it is checked that

- every name that POV-Ray's file declares is declared in ours, and no other but those with `_Inc_` in them, which are
  ours; macros have
  as many parameters; identifiers are of the same kind, which is what block they can stand in;
- numbers, vectors and colours are equal in all five terms, and so are the results of the macros in CALLS;
- functions are equal at 50 points; ours are evaluated by isl, POV-Ray's by POV-Ray;
- shapes, and what the macros in SHAPES make, are equal in pictures of 80x60 pixels, coloured by depth and lit: at most
  0.5 % of the
  pixels are off by more than 10 of 255.

Everything but POV-Ray's functions is evaluated by isl, once with `-I` our folder and once with POV-Ray's. Textures have
numbers of their
own and are compared for a look only: with --page, each is drawn on a ball, ours left and POV-Ray's right, and those
whose mean colours
are more than 10 % apart are listed. The page has their names in red.

The exit code is 1 if anything but a texture differs. Needs python3-numpy, python3-pil, and povray for the functions.
"""
import argparse
import collections
import os
import re
import shutil
import sys
import tempfile

import programs
from pictures import Image, np
from PIL import ImageDraw

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SIZE, BALL, COLUMNS = (80, 60), 72, 8
TOLERANCE = 2e-5  # POV-Ray keeps colours in single precision
# What a file expects to be included before it.
BEFORE = {'shapes2': ['shapes'], 'shapesq': ['shapes'], 'skies': ['colors'], 'stones1': ['colors'],
          'stones2': ['colors'],
          'stones': ['colors'], 'stoneold': ['colors'], 'woods': ['colors'], 'stdcam': ['colors'],
          'textures': ['colors']}
# They place objects, lights and cameras.
NOT_COMPARED = {'stdcam', 'stage1'}
# Macros that POV-Ray's files need for themselves.
INTERNAL = {'HFCreate_'}
OBJECTS = {'object', 'sphere', 'box', 'cylinder', 'cone', 'torus', 'plane', 'union', 'merge', 'intersection',
           'difference', 'quadric',
           'quartic', 'poly', 'cubic', 'prism'}
# Blocks that a name of each kind can stand in, with what they need besides.
BLOCKS = {'texture': 'texture {{ {} }}', 'pigment': 'pigment {{ {} }}', 'finish': 'finish {{ {} }}',
          'material': 'material {{ {} }}',
          'interior': 'interior {{ {} }}', 'sky_sphere': 'sky_sphere {{ {} }}', 'transform': 'transform {{ {} }}',
          'color_map': 'pigment {{ gradient x color_map {{ {} }} }}', 'camera': 'camera {{ {} }}',
          'object': 'object {{ {} }}'}
# Extra arguments of functions behind x, y, z.
EXTRA = {
    'f_sphere': '0.7', 'f_ellipsoid': '1.2, 0.8, 2', 'f_rounded_box': '0.1, 0.7, 0.5, 0.6',
    'f_superellipsoid': '0.5, 0.3',
    'f_torus': '0.8, 0.3', 'f_helix1': '2, 5, 0.1, 0.6, 1.2, 1, 20', 'f_helix2': '0, 5, 0.1, 0.6, 0, 2, 30',
    'f_hetero_mf': '0.9, 2, 5, 0.4, 0.7, 2', 'f_ridged_mf': '0.9, 2, 5, 0.8, 1.5, 3', 'f_noise_generator': '2',
    'f_bicorn': '1, 1.3', 'f_hyperbolic_torus': '1, 0.6, 0.3', 'f_parabolic_torus': '1, 0.6, 0.3',
    'f_torus2': '1, 0.7, 0.2',
    'f_ovals_of_cassini': '1, 0.4, 0.3, 0.2', 'f_quartic_cylinder': '1, 0.8, 0.3', 'f_witch_of_agnesi': '1, 0.04',
    'f_poly4': '-0.5, 0.3, 0.2, 0.1, -0.4', 'f_polytubes': '4, 0.3, 0.1, 0.2, 0.05, -0.1',
    'f_spikes_2d': '0.8, 3, 2, 0.5',
    'f_blob': '0.7, 0.9, 3, 0.6, 4', 'f_blob2': '0.8, 3, 1, 0.4', 'f_cross_ellipsoids': '0.3, 1.2, 1.5, 0.2',
    'f_isect_ellipsoids': '0.3, 1.2, 1.5, 0.2', 'f_flange_cover': '0.2, 1.5, 1.5, 0.3', 'f_enneper': '0.5',
    'f_mesh1': '0.4, 0.3, 1, 0.2, 1'}
# Functions of another number of arguments, at which they are called with the point's terms as they are used: A, B, C.
ARGUMENTS = {'sind': 'A', 'cosd': 'A', 'tand': 'A', 'asind': 'A/3', 'acosd': 'A/3', 'atand': 'A', 'atan2d': 'A, B',
             'max3': 'A, B, C',
             'min3': 'A, B, C', 'even': 'floor(9*A)', 'odd': 'floor(9*A)', 'f_sqr': 'A', 'sgn': 'A',
             'clip': 'A, -0.5, 0.7',
             'clamp': 'A, -0.5, 0.7', 'adj_range': 'A, 2, 5', 'adj_range2': 'A, -1, 1, 2, 5',
             'FnPovDispersion': '1.5 + A/4, 0.05'}
# Calls whose results are compared. Strings as they are, numbers and vectors by terms.
CALLS = {
    'strings': ['Str(pi)', 'VStr(<1, 2.5, -3>)', 'VStr2D(<1, 2>)', 'Vstr(<1, 2.5, -3>, 8, 2)', 'Vstr2D(<1, 2>, 6, 3)',
                'CRGBStr(color rgb <0.1, 0.2, 0.3>, 0, 3)', 'CRGBFTStr(color rgbft <0.1, 0.2, 0.3, 0.4, 0.5>, 6, 3)',
                'Triangle_Str(x, y, z)',
                'Smooth_Triangle_Str(x, y, z, y, x, z)'],
    'sunpos': [f'SunPos({arguments})/1e9' for arguments in (
        '2000, 6, 21, 12, 2, 0, 51.4667, 0', '2011, 12, 1, 23, 2, -75, -11.5, -80', '1995, 2, 28, 1, 30, 120, 35, 135',
        '2026, 9, 5, 0, 5, 15, 48.2, 16.4')]
        + ['Al', 'Az'],
    'ior': ['iorDiamond', 'dispDiamond', 'dispGlass'],
    'arrays': ['Sorted[0]', 'Sorted[7]', 'Sorted[19]', 'Reversed[3]', 'dimension_size(Resized, 1)', 'Resized[4]'],
    'shapes': ['Text_Width("timrom.ttf", "Word", 1.5, 0.1)', 'Text_Space("timrom.ttf", "Word", 1.5, 0.1)',
               'Isect(-5*z, z, sphere { 0, 1 }, Place)', 'Place',
               'IsectN(<0.5, 0, -5>, z, sphere { 0, 1 }, Place, Normal)', 'Normal',
               'Isect(-5*z, y, sphere { 0, 1 }, Place)', 'Low', 'High'],
    'screen': ['CamL', 'CamD', 'CamR', 'CamU', 'Camera_Zoom', 'Camera_Aspect_Ratio'],
    'functions': ['eval_pigment(pigment { agate }, <1.3, 2.7, 0.4>)'],
}
PREPARE = {
    'arrays': '''#declare S = seed(5); #declare Sorted = array[20] #declare I = 0;
#while (I < 20) #declare Sorted[I] = rand(S); #declare I = I + 1; #end
#declare Reversed = Sorted; #declare Resized = Sorted;
Sort_Array(Sorted) Reverse_Array(Reversed) Resize_Array(Resized, 5)''',
    'shapes': '''#declare Place = <9, 9, 9>; #declare Normal = <9, 9, 9>; #declare Low = 0; #declare High = 0;
Extents(box { -1, <2, 3, 4> }, Low, High)''',
    'screen': 'Set_Camera(<1, 2, -8>, <0, 1, 0.5>, 40)',
}
WAVES = '#declare Waves = function { 0.5 + 0.4*sin(9*x)*sin(7*y) }\n'
# Objects that macros make, cut to a ball of 3 about the origin.
SHAPES = {
    'shapes': [
        'Center_Object(box { 0, <1, 2, 1> }, x + y)', 'Align_Object(box { 0, <1, 2, 1> }, <1, -1, 0>, 0.5)',
        'Bevelled_Text("timrom.ttf", "B2", 7, 32, 0.1, 0.3, 0.05, no)',
        'Bevelled_Text("timrom.ttf", "S", 8, 30, 0.1, 0.5, 0, yes)',
        'Circle_Text("timrom.ttf", "round and", 0.7, 0.05, 0.3, 1.6, no, Align_Center, 90)',
        'Circle_Text("timrom.ttf", "left", 0.8, 0, 0.3, 1.2, no, Align_Left, 120)',
        'Circle_Text("timrom.ttf", "under", 0.7, 0.02, 0.3, 1.8, yes, Align_Right, -60)',
        'Circle_Text_Valigned("timrom.ttf", "crown", 0.8, 0.02, 0.1, 1.5, no, Align_Left, 150, -60)',
        'Wedge(50)', 'Wedge(180)', 'Wedge(290)', 'Spheroid(0.3*x, <1, 1.5, 0.6>)',
        'Connect_Spheres(-x, 0.8, <1, 0.7, 0>, 0.3)',
        'Supercone(-y, 1, 1.5, <0, 1, 0.5>, 1, 0.4)', 'Supercone(z, 1, 0.8, -z, 0.4, 1.1)',
        'Wire_Box(<-1, -1, -1>, <1, 0.6, 1.2>, 0.15, no)',
        'Wire_Box_Union(<-1, -1, -1>, <1, 0.6, -0.8>, 0.15)', 'Wire_Box_Merge(<-1, -1, -1>, <1, 0.6, 1.2>, 0.15)',
        'Round_Box(<-1, -1, -1>, <1, 0.6, 1.2>, 0.25, no)',
        'Round_Box_Union(<1, 0.6, 1.2>, <-1, -1, -1>, 0.25)', 'Round_Box_Merge(<-1, -1, -1>, <1, 0.6, -0.7>, 0.25)',
        'Round_Cylinder(-y, <0.5, 1, 0>, 1, 0.3, no)', 'Round_Cylinder_Union(-y, y, 0.6, 0.5)',
        'Round_Cylinder_Merge(-x, z, 0.6, 0.1)',
        'Round_Cone(-y, 1.2, <0.3, 1, 0>, 0.7, 0.2, no)', 'Round_Cone_Union(-x, 0.5, x, 0.9, 0.2)',
        'Round_Cone_Merge(-y, 0.7, y, 0.7, 0.3)',
        'Round_Cone2(-y, 1, <0.5, 1, 0>, 0.5, no)', 'Round_Cone2_Union(-x, 0.4, x, 0.9)',
        'Round_Cone2_Merge(-y, 0.7, y, 0.3)',
        'Round_Cone3(-y, 1, <0.5, 1, 0>, 0.5, no)', 'Round_Cone3_Union(-x, 0.4, x, 0.9)',
        'Round_Cone3_Merge(-y, 0.7, y, 0.3)',
        'union { Quad(<-1, -1, 0>, <-1, 1, 1>, <1, 1, 0>, <1, -1, -1>) }',
        'union { Smooth_Quad(<-1, -1, 0>, -z, <-1, 1, 0>, <0, 1, -2>, <1, 1, 0>, -z, <1, -1, 0>, <1, 0, -2>) }'],
    'shapes3': [
        'Segment_of_Object(Round_Box(<-1, 0, -1>, <1, 1, 1>, 0.2, no), 70)',
        'Segment_of_Object(torus { 1, 0.4 }, -250)',
        'Segment_of_CylinderRing(1.4, 0.9, 0.7, 100)', 'Segment_of_CylinderRing(0.9, 1.4, 0.7, -230)',
        'Segment_of_CylinderRing(1.4, 0.9, -0.7, 0)', 'Segment_of_Torus(1.2, 0.4, 130)',
        'Segment_of_Torus(1.2, 0.4, -220)',
        'Segment_of_Torus(1.2, 0.4, 360)', 'Round_N_Tube_Polygon(5, 0.2, 1.2, 0.4, 0, 0)',
        'Round_N_Tube_Polygon(3, 0.25, 0.9, 0.3, 0.5, 1)', 'Round_N_Tube_Polygon(6, 0.2, 1.2, 1.2, 1, 0)',
        'Pyramid_N(5, 1.3, 0.6, 1.5)', 'Pyramid_N(3, 1, 0, 1.6)', 'Pyramid_N_AB(6, <-1, 0, 0>, 1, <1, 1, 0.5>, 0.4)',
        'Column_N(7, 1, 1.2)', 'Column_N_AB(4, <-1, -0.5, 0>, <1, 0.7, 0>, 0.6)', 'Egg_Shape(1.1, 1.7)',
        'Facetted_Sphere(4, 9)',
        'Facetted_Egg_Shape(3, 8, 0.8, 1.4)', 'Facetted_Egg(5, 12)', 'Ring_Sphere(1.4, 1.45, 0.07, 0.05, 5, 7)',
        'Round_Pyramid_N_out(5, -y, 1.4, y, 0.8, 0.2, 1, 0)',
        'Round_Pyramid_N_out(4, -x, 0.6, <1, 0.5, 0>, 1.3, 0.15, 0, 0)',
        'Round_Pyramid_N_out(3, -y, 1.4, y, 0.2, 0.2, 1, 1)', 'Round_Pyramid_N_in(6, -y, 1.2, y, 0.5, 0.25, 1, 0)',
        'Rounded_Tube(1.4, 0.9, 0.15, 0.8, 0)', 'Rounded_Tube_AB(<-1, 0, 0>, <1, 0.4, 0>, 1, 0.6, 0.2, 1)',
        'Round_Cylinder_Tube(-y, <0.3, 1, 0>, 1, 0.2, 0, 0)', 'Round_Cylinder_Tube(-x, x, 0.8, 0.3, 1, 1)',
        'Round_Conic_Torus(1.5, 0.5, 1, 0.15, 0)', 'Round_Conic_Torus(1.2, 1, 0.4, 0.2, 1)',
        'Round_Conic_Prism(1.4, 0.5, 1, 0.9, 0.15, 0)', 'Round_Conic_Prism(1.2, 1, 0.4, 1.2, 0, 1)',
        'Half_Hollowed_Rounded_Cylinder1(3, 0.8, 0.3, 0.8, 0)', 'Half_Hollowed_Rounded_Cylinder1(2.6, 1, 0.25, 0, 1)',
        'Half_Hollowed_Rounded_Cylinder2(3, 1, 0.5, 0.1, 1, 0)',
        'Half_Hollowed_Rounded_Cylinder2(3, 0.9, 0.4, 0.15, 0, 1)'],
    'screen': ['Screen_Object(sphere { 0, 0.2 }, <0.9, 0.2>, <0.05, 0.02>, 1, 0.8)',
               'Screen_Object(box { 0, 0.2 }, <0, 1>, 0, 0, 1)',
               'Screen_Plane(texture { pigment { checker rgb 1 rgb x scale 0.2 } }, 0.5, <0.2, 0.3>, <0.9, 0.7>)'],
}
# Meshes, which isl does not have, are what POV-Ray's files make of these; POV-Ray itself draws them.
FIELDS = [WAVES + f'object {{ {call} }}' for call in (
    'HF_Square(Waves, no, no, <20, 15>, no, "", <-1.5, 0, -1.5>, <1.5, 0.8, 1.5>)',
    'HF_Square(Waves, yes, no, 20, yes, "", -1, 1)',
    'HF_Sphere(Waves, yes, no, <24, 12>, no, "", 0.2*x, 1, 0.3)',
    'HF_Cylinder(Waves, yes, no, <24, 12>, yes, "", -y, y, 0.9, 0.3)',
    'HF_Torus(Waves, no, no, <30, 12>, no, "", 1.2, 0.4, 0.2)')]

SHOW = '''camera { CAMERA }
light_source { <30, 50, -60> rgb 0.6 }
#declare Show = texture {
  pigment { gradient <-0.3, 0.6, 0.8> color_map { [0 rgb <0.1, 0.2, 0.9>] [0.5 rgb <0.2, 0.9,
                                                                           0.1>] [1 rgb <0.9, 0.3,
                                                                                  0.2>] } scale 9 translate -4 }
  finish { ambient 0.5 diffuse 0.6 }
}
background { rgb 0 }
'''
VIEW = 'location <2, 3, -7> right 4/3*x look_at <0, 0.2, 0> angle 46'
LIT_BALL = '''camera { location <0, 2, -4.5> right x look_at <0, 0.85, 0> angle 38 }
light_source { <4, 7, -6> rgb 0.9 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [1 rgb <0.2, 0.4, 0.8>] } } }
plane { y, -0.0013 pigment { checker rgb <0.25, 0.4, 0.55> rgb <0.8, 0.85, 0.5> } finish { ambient 0.1 diffuse 0.7 } }
sphere { <0.0137, 1.0071, 0.0053>, 1 SURFACE }
'''
LIT_SKY = '''camera { location 2*y right x look_at <0, 3.2, 5> angle 80 }
light_source { <40, 70, -60> rgb 0.9 }
background { rgb <0.2, 0.4, 0.8> }
plane { y, -0.0013 pigment { checker rgb <0.25, 0.4, 0.55> rgb <0.8, 0.85, 0.5> } finish { ambient 0.1 diffuse 0.7 } }
SURFACE
'''
ON_BALL = {
    'texture': 'texture { NAME }', 'material': 'material { NAME }', 'pigment': 'pigment { NAME }',
    'finish': 'pigment { rgb <0.8, 0.5, 0.35> } finish { NAME }',
    'interior': 'pigment { rgbf <0.95, 0.97, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { NAME }',
    'color_map': 'pigment { wood turbulence 0.1 scale 0.3 color_map { NAME } }'}
AS_SKY = {'sky_sphere': 'sky_sphere { NAME }', 'pigment': 'sky_sphere { pigment { NAME } }',
          'texture': 'sphere { 0, 10000 texture { NAME scale 1000 } hollow }', 'object': 'object { NAME hollow }'}

Declared = collections.namedtuple('Declared', 'kind parameters')


def read(path):
    with open(path, encoding='latin1') as stream:
        return re.sub(r'/\*.*?\*/|//[^\n]*', '', stream.read(), flags=re.DOTALL)


def outside_of_macros(text):
    """The text without the bodies of macros: what they declare is declared when they are called."""
    kept, depth, at, inside = [], [], 0, False
    for match in re.finditer(r'"(?:\\.|[^"\\])*"|#\s*(macro|if|ifdef|ifndef|while|for|switch|end)\b', text):
        word = match.group(1)
        if word == 'end':
            if depth and depth.pop() == 'macro' and 'macro' not in depth:
                at, inside = match.end(), False
        elif word:
            depth.append(word)
            if word == 'macro' and not inside:
                closing = text.index(')', match.end()) + 1
                kept.append(text[at:closing])
                inside = True
    return ''.join(kept) + text[at:]


def declared(text):
    """The names that a file declares, with their kinds as the text tells: a block's word, `macro`, or `value`."""
    found = {}
    for word, name, rest in re.findall(
            r'#\s*(declare|macro)\s+(?:deprecated\s+(?:once\s+)?(?:"[^"]*"\s*)?)?(\w+)\s*=?\s*(?=(.{0,400}))',
            outside_of_macros(text), re.DOTALL):
        if word == 'macro':
            inside = re.match(r'\(([^)]*)\)', rest)
            found[name] = Declared('macro', re.findall(r'\w+', inside.group(1)))
            continue
        block = re.match(r'([a-z_0-9]+)\s*(?:\([^)]*\)\s*)?\{', rest)
        kind = block.group(1) if block else 'value'
        found.setdefault(name, Declared('object' if kind in OBJECTS else 'color_map' if kind == 'colour_map' else kind,
                                        None))
    for name in re.findall(r'#\s*undef\s+(\w+)', text):
        if found.get(name, Declared('', None)).kind == 'macro':
            del found[name]
    return found


class Comparison:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.differences = 0

    def say(self, file, text):
        print(f'{file:12} {text}', flush=True)

    def differs(self, file, text):
        self.differences += 1
        self.say(file, 'DIFFERS: ' + text)

    def path(self, file, ours):
        name = file if '.' in file else file + '.inc'
        return os.path.join(self.options.stdlib if ours else self.options.include, name)

    def scene(self, file, body):
        includes = ''.join(f'#include "{name if "." in name else name + ".inc"}"\n' for name in BEFORE.get(file, [])
                           + [file])
        return '#version 3.7;\nglobal_settings { assumed_gamma 1 }\n' + includes + body

    def write(self, text):
        path = os.path.join(self.folder, 'scene.pov')
        with open(path, 'w', encoding='utf8') as stream:
            stream.write(text)
        return path

    def libraries(self, ours):
        return ['--no-system-libraries', '-I', self.options.stdlib if ours else self.options.include]

    def check(self, text, ours):
        """What a scene prints, and its errors."""
        ran = programs.Ran([self.options.isl, 'check', self.write(text), *self.libraries(ours), '--allow-write',
                            self.folder], self.folder, 120)
        return ran.errors, re.findall(r'error: (.*)', ran.errors)

    def render(self, text, ours, size=SIZE):
        picture = os.path.join(self.folder, 'picture.png')
        if os.path.exists(picture):
            os.remove(picture)
        ran = programs.run_isl(self.options, self.write(text), picture, size, *self.libraries(ours), folder=self.folder)
        return self.pixels(picture), '' if ran.code == 0 else programs.isl_message(ran)

    def render_by_povray(self, text, size=SIZE):
        picture = os.path.join(self.folder, 'picture.png')
        if os.path.exists(picture):
            os.remove(picture)
        ran = programs.run_povray(self.options, self.write(text), picture, size, folder=self.folder)
        return self.pixels(picture), '' if ran.code == 0 else programs.povray_message(ran)

    @staticmethod
    def pixels(picture):
        if not os.path.exists(picture):
            return None
        with Image.open(picture) as image:
            return np.asarray(image.convert('RGB')).astype(float)

    def names(self, file):
        """Compares names; returns those of POV-Ray's file that ours has."""
        ours, theirs = (declared(read(self.path(file, own))) for own in (True, False))
        missing = [name for name in theirs if name not in ours and name not in INTERNAL]
        extra = [name for name in ours if name not in theirs and '_Inc_' not in name]
        if missing:
            self.differs(file, 'names missing: ' + ', '.join(missing))
        if extra:
            self.differs(file, 'names too many: ' + ', '.join(extra))
        for name, one in theirs.items():
            if name in ours and one.kind == 'macro' and (ours[name].kind != 'macro'
                                                         or len(ours[name].parameters) != len(one.parameters)):
                self.differs(file,
                             f'macro {name}: {len(one.parameters)} parameters in POV-Ray\'s, {ours[name]} in ours')
        return {name: one for name, one in theirs.items() if name in ours}

    def kinds(self, file, names):
        """Every name is used in a block of POV-Ray's kind, in one scene, of which an error names the line."""
        rows = [(name, BLOCKS[one.kind].format(name)) for name, one in names.items() if one.kind in BLOCKS]
        if not rows:
            return 0
        head = self.scene(file, '')
        text = head + ''.join(f'#declare Used_{i} = {block}\n' for i, (_, block) in enumerate(rows))
        errors, _ = self.check(text, True)
        for line in {int(n) for n in re.findall(r'scene\.pov:(\d+):\d+: error', errors)}:
            at = line - head.count('\n') - 1
            if 0 <= at < len(rows):
                self.differs(file, f'kind of {rows[at][0]}: cannot be used as {rows[at][1]}')
        return len(rows)

    def values_of(self, file, expressions, ours):
        """For each the text that a scene prints: five terms, or a string."""
        body = PREPARE.get(file, '') + '\n'
        for i, expression in enumerate(expressions):
            is_text = file == 'strings'
            shown = expression if is_text else f'vstr(5, {expression} + <0, 0, 0, 0, 0>, " ", 0, 9)'
            body += f'#declare Value_ = {shown};\n#debug concat("\\n@{i} ", Value_, "\\n")\n'
        output, errors = self.check(self.scene(file, body), ours)
        return dict(re.findall(r'^@(\d+) (.*)$', output, re.MULTILINE)), errors

    def compare_values(self, file, expressions):
        ours, errors = self.values_of(file, expressions, True)
        theirs, _ = self.values_of(file, expressions, False)
        count = 0
        for i, expression in enumerate(expressions):
            a, b = ours.get(str(i)), theirs.get(str(i))
            if b is None:
                if a is None:
                    continue
                self.say(file, f'{expression}: not evaluated with POV-Ray\'s file')
                continue
            count += 1
            if not same_words(a, b):
                self.differs(file, f'value of {expression}: {a} in ours, {b} in POV-Ray\'s'
                             + (f' ({errors[0]})' if a is None and errors else ''))
        return count

    def functions(self, file, names):
        """Ours by isl, POV-Ray's by POV-Ray, at the same points."""
        if not self.options.povray or not names:
            return 0, []
        points = np.random.default_rng(1).uniform(-1.1, 1.1, (50, 3)).round(3)
        count, skipped = 0, []
        for name in names:
            body = self.calls(name, ARGUMENTS.get(name, 'A, B, C' + (', ' + EXTRA[name] if name in EXTRA else '')),
                              points)
            output, errors = self.check(self.scene(file, body), True)
            arity = re.match(r'this function takes (\d+) arguments', errors[0]) if errors else None
            if arity:
                body = self.calls(name, 'A, B, C' + ', 0.7' * (int(arity.group(1)) - 3), points)
                output, errors = self.check(self.scene(file, body), True)
            if errors and programs.is_refusal(errors[0]):
                skipped.append(name)
                continue
            a = re.findall(r'^@0 (.*)$', output, re.MULTILINE)
            log = os.path.join(self.folder, 'debug.txt')
            if os.path.exists(log):
                os.remove(log)
            programs.Ran([self.options.povray, f'+I{self.write(self.scene(file, body))}', '-D', '+W8', '+H8', '-F',
                          '-GA', '+GDdebug.txt',
                          f'+L{self.options.include}'], self.folder, 60)
            b = []
            if os.path.exists(log):
                with open(log, encoding='latin1') as stream:
                    b = re.findall(r'^@0 (.*)$', stream.read(), re.MULTILINE)
            count += 1
            wrong = [(p, q) for p, q in zip(a, b) if not same_words(p, q, 2e-4)]
            if len(a) != len(points) or len(b) != len(points):
                self.differs(file, f'function {name}: {len(a)} values in ours, {len(b)} in POV-Ray\'s'
                             + (f' ({errors[0]})' if errors else ''))
            elif len(wrong) > 1:  # one point may be at a step
                self.differs(file, f'function {name} at {len(wrong)} of {len(points)} points: {wrong[0][0]} in ours, '
                                   f'{wrong[0][1]} in POV-Ray\'s')
        return count, skipped

    @staticmethod
    def calls(name, arguments, points):
        """A scene's text that prints the function's value at each point, whose terms are A, B and C."""
        body = ''
        for point in points:
            filled = arguments
            for letter, value in zip('ABC', point):
                filled = re.sub(rf'\b{letter}\b', f'({value})', filled)
            term = '.gray' if name == 'f_hexagon' else ''
            body += f'#debug concat("\\n@0 ", str({name}({filled}){term}, 0, 6), "\\n")\n'
        return body

    def shapes(self, file, objects, by_povray=False):
        for text in objects:
            camera = VIEW
            if file == 'chars':
                camera = 'location <1.5, 3.5, -11> right 4/3*x look_at <0, 2.5, 0.5> angle 46'
            if file == 'screen':  # it has a camera
                shown = SHOW.replace('camera { CAMERA }', '') + f'object {{ {text} texture {{ Show }} }}\n'
            elif by_povray:
                shown = SHOW.replace('CAMERA', camera) + text.replace('object {',
                                                                      'object { union {') + ' texture { Show } }\n'
            else:
                cut = f'intersection {{ object {{ {text} }} sphere {{ 0, 3 }} texture {{ Show }} }}\n'
                whole = f'object {{ {text} texture {{ Show }} }}\n'
                shown = SHOW.replace('CAMERA', camera) + (cut if is_infinite(text) else whole)
            scene = self.scene(file, shown)
            a, ours = self.render(scene, True)
            b, theirs = (None, '') if by_povray else self.render(scene, False)
            # What isl cannot make of POV-Ray's file is left to POV-Ray, whose edges differ by a few pixels.
            is_foreign = b is None and a is not None and self.options.povray is not None
            if is_foreign:
                b, theirs = self.render_by_povray(scene)
            label = text.split('\n')[-1]
            if a is None or b is None:
                if a is None and b is None and programs.is_refusal(ours):
                    self.say(file, f'{label}: {ours}')
                else:
                    self.differs(file, f'shape {label}: {ours or "drawn"} in ours, {theirs or "drawn"} in POV-Ray\'s')
                continue
            off = (np.abs(a - b).max(2) > 10).mean()
            if off > (0.03 if is_foreign else 0.005) or a.max() < 5:
                self.differs(file, f'shape {label}: {100 * off:.1f} % of the pixels' + (', nothing is seen'
                                                                                        if a.max() < 5 else ''))

    def textures(self, file, names):
        """Balls with ours and with POV-Ray's: file, name, both pictures, how far the mean colours are apart."""
        kinds = AS_SKY if file == 'skies' else ON_BALL
        for name, one in names.items():
            if one.kind in kinds:
                body = (LIT_SKY if file == 'skies' else LIT_BALL).replace('SURFACE',
                                                                          kinds[one.kind].replace('NAME', name))
                pictures = [self.render(self.scene(file, body), ours, (BALL, BALL))[0] for ours in (True, False)]
                if any(p is None for p in pictures):
                    whose = 'ours' if pictures[0] is None else "POV-Ray's"
                    self.differs(file, f'{one.kind} {name} is not drawn with {whose}')
                    continue
                y, x = np.mgrid[:BALL, :BALL] - BALL / 2
                means = [linear(p)[np.hypot(x, y) < BALL * .33].mean(0) for p in pictures]
                yield file, name, pictures, np.abs(means[0] - means[1]).max() / max(means[1].max(), .02)


def linear(picture):
    v = picture / 255
    return np.where(v <= .04045, v / 12.92, ((v + .055) / 1.055) ** 2.4)


def same_words(a, b, tolerance=TOLERANCE):
    """Whether two texts have the same words; numbers may differ a little."""
    if a is None or b is None:
        return False
    left, right = a.split(), b.split()
    if len(left) != len(right):
        return False
    for p, q in zip(left, right):
        if p == q:
            continue
        try:
            if abs(float(p) - float(q)) > tolerance * max(1, abs(float(q))):
                return False
        except ValueError:
            return False
    return True


def is_infinite(text):
    return re.match(r'(Cylinder|QCone|Plane|Paraboloid|Hyperboloid|Wedge)|'
                    r'[A-Z]\w*(Saddle|Trough|Torus|Curve|Loop|Hat|surf|Cylinder|Paraboloid)\w*$|'
                    r'(Folium|Glob_5|Twin_Glob|Bicorn|Lemniscate|Piriform|Steiner_Surface)$', text) is not None


def page(rows):
    cell = 2 * BALL + 6, BALL + 18
    sheet = Image.new('RGB', (COLUMNS * cell[0], -(-len(rows) // COLUMNS) * cell[1]), 'white')
    drawing = ImageDraw.Draw(sheet)
    for at, (file, name, pictures, apart) in enumerate(rows):
        x, y = at % COLUMNS * cell[0], at // COLUMNS * cell[1]
        drawing.text((x + 2, y), f'{file}: {name}'[:24], fill='red' if apart > .1 else 'black')
        for i, picture in enumerate(pictures):
            sheet.paste(Image.fromarray(picture.astype(np.uint8)), (x + i * BALL, y + 12))
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('files', nargs='*', metavar='FILE', help='names of files without .inc [all]')
    parser.add_argument('--page', metavar='PAGE.png', help='draw all textures side by side')
    parser.add_argument('--stdlib', default=os.path.join(ROOT, 'stdlib'), help='our files [stdlib]')
    programs.add_program_options(parser)
    options = parser.parse_args()
    if not shutil.which(options.povray):
        print('no povray: functions and height fields are not compared')
        options.povray = None
    else:
        options.povray = os.path.abspath(shutil.which(options.povray))
    found = shutil.which(options.isl)
    if not found:
        sys.exit(f'standard_files.py: no program {options.isl}: build it, or say where it is with --isl')
    options.isl, options.stdlib = os.path.abspath(found), os.path.abspath(options.stdlib)
    if not os.path.isdir(options.include):
        sys.exit(f"standard_files.py: no folder {options.include} "
                 "(POV-Ray's files are in Debian's package povray-includes)")
    listed = sorted(name for name in os.listdir(options.include) if name.endswith(('.inc', '.map')))
    have = [name for name in listed if os.path.exists(os.path.join(options.stdlib, name))]
    files = options.files or [name[:-4] if name.endswith('.inc') else name for name in have]
    if not options.files:
        print('not in ours:', ', '.join(name for name in listed if name not in have))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(options, folder)
        for file in files:
            if file in NOT_COMPARED:
                continue
            names = comparison.names(file)
            kinds = comparison.kinds(file, names)
            values = [name for name, one in names.items() if one.kind == 'value'
                      and not re.search(r'_temp$', name, re.I)]
            count = comparison.compare_values(file, values + CALLS.get(file, []))
            functions, skipped = comparison.functions(file, [name for name, one in names.items()
                                                             if one.kind == 'function'])
            objects = [name for name, one in names.items() if one.kind == 'object'] if file != 'skies' else []
            comparison.shapes(file, objects + SHAPES.get(file, []))
            if file == 'shapes' and options.povray:
                comparison.shapes(file, FIELDS, True)
            drawn = len(objects) + len(SHAPES.get(file, []))
            comparison.say(file, f'{len(names)} names, {kinds} kinds, {count} values, {functions} functions, '
                           f'{drawn} shapes compared'
                           + (f'; cannot be evaluated: {", ".join(skipped)}' if skipped else ''))
            if options.page:
                for row in comparison.textures(file, names):
                    rows.append(row)
                    if row[3] > .1:
                        comparison.say(file, f'{row[1]}: mean colours are {100 * row[3]:.0f} % apart')
        if options.page and rows:
            page(rows).save(options.page)
            near = sum(row[3] <= .1 for row in rows)
            print(f'{near} of {len(rows)} textures have mean colours within 10 %; the page: {options.page}')
    print(f'{comparison.differences} differences')
    return 1 if comparison.differences else 0


if __name__ == '__main__':
    sys.exit(main())
