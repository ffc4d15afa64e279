	sphere {	"äöü",	1 + }
